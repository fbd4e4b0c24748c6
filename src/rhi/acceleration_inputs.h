// The inputs of an acceleration structure build as Vulkan's structs, and the memory that the build
// needs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "rhi/acceleration_build.h"
#include "rhi/buffer.h"
#include "rhi/device.h"
#include "rhi/vulkan.h"

namespace hm::rhi {

struct Build {
    std::string name;
    VkAccelerationStructureTypeKHR type = VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR;
    VkBuildAccelerationStructureFlagsKHR flags =
        VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
    std::vector<VkAccelerationStructureGeometryKHR> geometries;
    std::vector<VkAccelerationStructureBuildRangeInfoKHR> ranges;
    std::uint64_t structure_bytes = 0;
    std::uint64_t scratch_bytes = 0;  // a multiple of the scratch alignment

    VkAccelerationStructureBuildGeometryInfoKHR info() const {
        return {.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR,
                .type = type,
                .flags = flags,
                .mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR,
                .geometryCount = static_cast<std::uint32_t>(geometries.size()),
                .pGeometries = geometries.data()};
    }
};

// The required alignment of each build's part of the scratch memory.
std::uint64_t scratch_alignment(const Device& device);

// Fails with ErrorKind::device_failed if the input exceeds the device's limits.
Result<Build> plan_blas(const Device& device, const BlasInput& input, bool compact);

// Writes the instances in Vulkan's layout to a buffer that a build can read.
Result<Buffer> upload_instances(Device& device, const std::string& name,
                                std::span<const TlasInstance> instances);
// Plans the build over `count` instances at a device address.
Build plan_tlas(const Device& device, const std::string& name, std::uint64_t address,
                std::uint32_t count);

}  // namespace hm::rhi
