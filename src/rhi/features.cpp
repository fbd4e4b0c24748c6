#include "rhi/features.h"

namespace hm::rhi {

FeatureChain::FeatureChain(bool with_reorder) {
    reorder.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_INVOCATION_REORDER_FEATURES_NV;
    ray_tracing.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_FEATURES_KHR;
    acceleration.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR;
    vulkan13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    vulkan12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    if (with_reorder) ray_tracing.pNext = &reorder;
    acceleration.pNext = &ray_tracing;
    vulkan13.pNext = &acceleration;
    vulkan12.pNext = &vulkan13;
    features.pNext = &vulkan12;
}

#define HM_FEATURE(part, name, required, purpose)                                           \
    Feature {                                                                               \
#name, purpose, required, [](FeatureChain & c) -> VkBool32& { return c.part.name; } \
    }

std::span<const Feature> all_features() {
    static const Feature kFeatures[] = {
        HM_FEATURE(ray_tracing, rayTracingPipeline, true, "tracing rays"),
        HM_FEATURE(acceleration, accelerationStructure, true, "finding what a ray hits"),
        HM_FEATURE(vulkan12, bufferDeviceAddress, true, "vertices by address"),
        HM_FEATURE(vulkan12, scalarBlockLayout, true, "structs laid out as in C++"),
        HM_FEATURE(vulkan12, timelineSemaphore, true, "waiting for submissions"),
        HM_FEATURE(vulkan12, runtimeDescriptorArray, true, "the table of textures"),
        HM_FEATURE(vulkan12, shaderSampledImageArrayNonUniformIndexing, true,
                   "a texture chosen for each ray"),
        HM_FEATURE(vulkan12, descriptorBindingPartiallyBound, true, "the table of textures"),
        HM_FEATURE(vulkan12, descriptorBindingSampledImageUpdateAfterBind, true,
                   "the table of textures"),
        HM_FEATURE(vulkan13, synchronization2, true, "barriers"),
        HM_FEATURE(vulkan13, maintenance4, true, "shaders compiled for Vulkan 1.3"),
        HM_FEATURE(reorder, rayTracingInvocationReorder, false, "rays sorted before shading"),
    };
    return kFeatures;
}

#undef HM_FEATURE

std::span<const Extension> all_extensions() {
    static const Extension kExtensions[] = {
        {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, "finding what a ray hits", true},
        {VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME, "tracing rays", true},
        {VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME, "acceleration structures need it", true},
        {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME, "images bound while recording", true},
        {VK_EXT_MEMORY_BUDGET_EXTENSION_NAME, "knowing how much memory is free", false},
        {VK_NV_RAY_TRACING_INVOCATION_REORDER_EXTENSION_NAME, "rays sorted before shading", false},
    };
    return kExtensions;
}

}  // namespace hm::rhi
