// Describes the physical devices that the loader offers, without creating a VkDevice, and selects
// one of them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "rhi/capabilities.h"
#include "rhi/vulkan.h"

namespace hm::rhi {

enum class DeviceKind { discrete, integrated, virtual_gpu, cpu, other };

// Limits that callers depend on.
struct Limits {
    std::uint32_t max_textures = 0;  // sampled images in one bindless table
    std::uint32_t max_recursion_depth = 0;
    std::uint64_t max_instances = 0;   // of a top-level acceleration structure
    std::uint64_t max_geometries = 0;  // of a bottom-level one
    std::uint64_t max_triangles = 0;   // of a bottom-level one, over its geometries
    std::uint64_t max_buffer_bytes = 0;
    std::uint64_t max_storage_buffer_bytes = 0;  // maximum range of one binding
    std::uint32_t max_image_side = 0;
    std::uint32_t max_rays_per_trace = 0;  // width * height * depth of trace_rays
    std::uint32_t max_push_constant_bytes = 0;
    bool reorders_rays = false;      // VK_NV_ray_tracing_invocation_reorder really reorders
    double timestamp_period_ns = 0;  // 0: no timestamps
};

struct PhysicalDevice {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    std::uint32_t index = 0;  // N of vulkan:N
    std::string name;         // "NVIDIA H200"
    DeviceKind kind = DeviceKind::other;
    std::string driver;       // "NVIDIA 580.159.03"
    std::string api_version;  // "1.4.303"
    std::uint32_t vendor_id = 0;
    std::array<std::uint8_t, VK_UUID_SIZE> device_uuid{};
    std::array<std::uint8_t, VK_UUID_SIZE> cache_uuid{};  // of pipeline caches
    std::uint64_t memory_bytes = 0;                       // its largest device-local heap
    std::uint32_t queue_family = 0;                       // compute, and graphics if one has both
    Limits limits;
    std::vector<Capability> capabilities;

    // usable(): has all required capabilities. has(): has the optional capability of that name.
    bool usable() const { return missing(capabilities).empty(); }
    bool has(std::string_view capability) const;
};

// For Instance::devices.
Result<PhysicalDevice> describe(VkPhysicalDevice handle, std::uint32_t index);

// The error message if the loader finds no driver.
inline constexpr const char* kNoDevices =
    "the loader finds no device; install the graphics card's Vulkan driver, or name its manifest "
    "in VK_DRIVER_FILES";

// "discrete GPU", "CPU", ...
std::string kind_name(DeviceKind kind);

// The best usable device: discrete before integrated GPUs, then the one with more memory.
// Never one of kind cpu. Fails with ErrorKind::no_device and says what each device lacks.
Result<PhysicalDevice> choose_best(std::span<const PhysicalDevice> devices);

// vulkan:N, of any kind. Fails with ErrorKind::no_device if there is no such device or it lacks
// something.
Result<PhysicalDevice> choose_index(std::span<const PhysicalDevice> devices, std::uint32_t index);

}  // namespace hm::rhi
