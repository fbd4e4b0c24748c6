#include "rhi/physical_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "base/text.h"
#include "rhi/error.h"
#include "rhi/features.h"

namespace hm::rhi {

namespace {

// A family with compute, preferably also graphics: the main queue, which every driver has.
std::optional<std::uint32_t> find_queue_family(const std::vector<VkQueueFamilyProperties>& all) {
    std::optional<std::uint32_t> found;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        if ((all[i].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) continue;
        if ((all[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0) return i;
        if (!found) found = i;
    }
    return found;
}

std::vector<VkQueueFamilyProperties> queue_families(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    return families;
}

Result<std::set<std::string>> extensions_of(VkPhysicalDevice device, const std::string& name) {
    std::vector<VkExtensionProperties> properties;
    VkResult result = VK_INCOMPLETE;
    while (result == VK_INCOMPLETE) {
        std::uint32_t count = 0;
        HM_TRY(check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr),
                     "vkEnumerateDeviceExtensionProperties", name));
        properties.resize(count);
        result = vkEnumerateDeviceExtensionProperties(device, nullptr, &count, properties.data());
        HM_TRY(check(result, "vkEnumerateDeviceExtensionProperties", name));
        properties.resize(count);
    }
    std::set<std::string> names;
    for (const VkExtensionProperties& extension : properties)
        names.insert(extension.extensionName);
    return names;
}

std::set<std::string> features_of(VkPhysicalDevice device) {
    FeatureChain chain(true);
    vkGetPhysicalDeviceFeatures2(device, &chain.features);
    std::set<std::string> names;
    for (const Feature& feature : all_features())
        if (feature.field(chain) == VK_TRUE) names.insert(feature.name);
    return names;
}

std::uint64_t largest_device_heap(VkPhysicalDevice device) {
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(device, &memory);
    std::uint64_t largest = 0;
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i)
        if ((memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0)
            largest = std::max(largest, std::uint64_t{memory.memoryHeaps[i].size});
    return largest;
}

DeviceKind kind_of(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return DeviceKind::discrete;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return DeviceKind::integrated;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return DeviceKind::virtual_gpu;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return DeviceKind::cpu;
        default:
            return DeviceKind::other;
    }
}

// The property structs of interest, chained.
struct PropertyChain {
    VkPhysicalDeviceRayTracingInvocationReorderPropertiesNV reorder{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_INVOCATION_REORDER_PROPERTIES_NV};
    VkPhysicalDeviceRayTracingPipelinePropertiesKHR ray_tracing{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_PROPERTIES_KHR,
        .pNext = &reorder};
    VkPhysicalDeviceAccelerationStructurePropertiesKHR acceleration{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR,
        .pNext = &ray_tracing};
    VkPhysicalDeviceVulkan13Properties vulkan13{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES, .pNext = &acceleration};
    VkPhysicalDeviceVulkan12Properties vulkan12{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES, .pNext = &vulkan13};
    VkPhysicalDeviceVulkan11Properties vulkan11{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES, .pNext = &vulkan12};
    VkPhysicalDeviceProperties2 base{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                     .pNext = &vulkan11};
};

void read_limits(const PropertyChain& properties, Limits& limits) {
    const VkPhysicalDeviceLimits& base = properties.base.properties.limits;
    limits.max_textures =
        std::min(properties.vulkan12.maxPerStageDescriptorUpdateAfterBindSampledImages,
                 properties.vulkan12.maxDescriptorSetUpdateAfterBindSampledImages);
    limits.max_recursion_depth = properties.ray_tracing.maxRayRecursionDepth;
    limits.max_instances = properties.acceleration.maxInstanceCount;
    limits.max_geometries = properties.acceleration.maxGeometryCount;
    limits.max_triangles = properties.acceleration.maxPrimitiveCount;
    limits.max_buffer_bytes = properties.vulkan13.maxBufferSize;
    limits.max_storage_buffer_bytes = base.maxStorageBufferRange;
    limits.max_image_side = base.maxImageDimension2D;
    limits.max_rays_per_trace = properties.ray_tracing.maxRayDispatchInvocationCount;
    limits.max_push_constant_bytes = base.maxPushConstantsSize;
    limits.reorders_rays = properties.reorder.rayTracingInvocationReorderReorderingHint ==
                           VK_RAY_TRACING_INVOCATION_REORDER_MODE_REORDER_NV;
}

// A device's name in a list: "vulkan:0 (NVIDIA H200)".
std::string label(const PhysicalDevice& device) {
    return fmt::format("vulkan:{} ({})", device.index, device.name);
}

std::string why_not(const PhysicalDevice& device) {
    const std::vector<std::string> lacks = missing(device.capabilities);
    if (!lacks.empty()) return fmt::format("{} lacks {}", label(device), joined(lacks, ", "));
    return fmt::format("{} runs on the CPU, and only serves when it is named", label(device));
}

}  // namespace

Result<PhysicalDevice> describe(VkPhysicalDevice handle, std::uint32_t index) {
    PropertyChain properties;
    vkGetPhysicalDeviceProperties2(handle, &properties.base);
    const VkPhysicalDeviceProperties& base = properties.base.properties;

    PhysicalDevice device;
    device.handle = handle;
    device.index = index;
    device.name = base.deviceName;
    device.kind = kind_of(base.deviceType);
    device.api_version =
        fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(base.apiVersion),
                    VK_API_VERSION_MINOR(base.apiVersion), VK_API_VERSION_PATCH(base.apiVersion));
    device.driver =
        fmt::format("{} {}", properties.vulkan12.driverName, properties.vulkan12.driverInfo);
    device.vendor_id = base.vendorID;
    std::ranges::copy(properties.vulkan11.deviceUUID, device.device_uuid.begin());
    std::ranges::copy(base.pipelineCacheUUID, device.cache_uuid.begin());
    device.memory_bytes = largest_device_heap(handle);
    read_limits(properties, device.limits);

    Offer offer;
    offer.api_version = base.apiVersion;
    HM_TRY_ASSIGN(offer.extensions, extensions_of(handle, device.name));
    offer.features = features_of(handle);
    const std::vector<VkQueueFamilyProperties> families = queue_families(handle);
    if (const std::optional<std::uint32_t> family = find_queue_family(families)) {
        device.queue_family = *family;
        offer.computes = true;
        offer.timestamps =
            families[*family].timestampValidBits > 0 && base.limits.timestampPeriod > 0;
        if (offer.timestamps)
            device.limits.timestamp_period_ns = static_cast<double>(base.limits.timestampPeriod);
    }
    device.capabilities = judge(offer);
    return device;
}

bool PhysicalDevice::has(std::string_view capability) const {
    const auto found = std::ranges::find(capabilities, capability, &Capability::name);
    return found != capabilities.end() && found->present;
}

std::string kind_name(DeviceKind kind) {
    switch (kind) {
        case DeviceKind::discrete:
            return "discrete GPU";
        case DeviceKind::integrated:
            return "integrated GPU";
        case DeviceKind::virtual_gpu:
            return "virtual GPU";
        case DeviceKind::cpu:
            return "CPU";
        case DeviceKind::other:
            break;
    }
    return "other";
}

Result<PhysicalDevice> choose_best(std::span<const PhysicalDevice> devices) {
    const PhysicalDevice* best = nullptr;
    // Lower is better; a virtual GPU is a share of a card.
    const auto order = [](const PhysicalDevice& device) {
        const int rank = device.kind == DeviceKind::discrete      ? 0
                         : device.kind == DeviceKind::virtual_gpu ? 1
                         : device.kind == DeviceKind::integrated  ? 2
                                                                  : 3;
        return std::tuple(rank, ~device.memory_bytes, device.index);
    };
    std::vector<std::string> reasons;
    for (const PhysicalDevice& device : devices) {
        if (device.kind == DeviceKind::cpu || !device.usable())
            reasons.push_back(why_not(device));
        else if (best == nullptr || order(device) < order(*best))
            best = &device;
    }
    if (best != nullptr) return *best;
    if (devices.empty()) return fail(ErrorKind::no_device, "Vulkan", "", kNoDevices);
    return fail(ErrorKind::no_device, "Vulkan", "",
                fmt::format("no device serves: {}", joined(reasons, "; ")));
}

Result<PhysicalDevice> choose_index(std::span<const PhysicalDevice> devices, std::uint32_t index) {
    if (devices.empty()) return fail(ErrorKind::no_device, "Vulkan", "", kNoDevices);
    const auto found = std::ranges::find(devices, index, &PhysicalDevice::index);
    if (found == devices.end()) {
        std::vector<std::string> labels;
        for (const PhysicalDevice& device : devices)
            labels.push_back(label(device));
        return fail(ErrorKind::no_device, "Vulkan", "",
                    fmt::format("there is no vulkan:{}, only {}", index, joined(labels, ", ")));
    }
    if (!found->usable()) return fail(ErrorKind::no_device, "Vulkan", "", why_not(*found));
    return *found;
}

}  // namespace hm::rhi
