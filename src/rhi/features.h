// The feature structs that we query and enable, and our names for their fields.
#pragma once

#include <span>

#include "rhi/vulkan.h"

namespace hm::rhi {

// Vulkan's pNext chain of structs; not movable, because they point to each other.
struct FeatureChain {
    VkPhysicalDeviceRayTracingInvocationReorderFeaturesNV reorder{};
    VkPhysicalDeviceRayTracingPipelineFeaturesKHR ray_tracing{};
    VkPhysicalDeviceAccelerationStructureFeaturesKHR acceleration{};
    VkPhysicalDeviceVulkan13Features vulkan13{};
    VkPhysicalDeviceVulkan12Features vulkan12{};
    VkPhysicalDeviceFeatures2 features{};

    // Structs of extensions that are not enabled are omitted from the chain.
    explicit FeatureChain(bool with_reorder);
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;
};

struct Feature {
    const char* name;
    const char* purpose;
    bool required;
    VkBool32& (*field)(FeatureChain&);
};

std::span<const Feature> all_features();

struct Extension {
    const char* name;
    const char* purpose;
    bool required;
};

std::span<const Extension> all_extensions();

}  // namespace hm::rhi
