// The functions that the layer can make fail: all whose result the program or its memory allocator
// checks. CALL(name, kind), with kinds: fails; loses, if the device may be lost too; names, which
// fails only if ordered by name.
#pragma once

#define HM_TROUBLE_INSTANCE_CALLS(CALL)               \
    CALL(vkEnumeratePhysicalDevices, fails)           \
    CALL(vkEnumerateDeviceExtensionProperties, fails) \
    CALL(vkGetPhysicalDeviceImageFormatProperties, fails)

#define HM_TROUBLE_DEVICE_CALLS(CALL)                 \
    CALL(vkAllocateCommandBuffers, fails)             \
    CALL(vkAllocateDescriptorSets, fails)             \
    CALL(vkAllocateMemory, fails)                     \
    CALL(vkBeginCommandBuffer, fails)                 \
    CALL(vkBindBufferMemory, fails)                   \
    CALL(vkBindBufferMemory2, fails)                  \
    CALL(vkBindImageMemory, fails)                    \
    CALL(vkBindImageMemory2, fails)                   \
    CALL(vkCreateAccelerationStructureKHR, fails)     \
    CALL(vkCreateBuffer, fails)                       \
    CALL(vkCreateCommandPool, fails)                  \
    CALL(vkCreateComputePipelines, fails)             \
    CALL(vkCreateDescriptorPool, fails)               \
    CALL(vkCreateDescriptorSetLayout, fails)          \
    CALL(vkCreateImage, fails)                        \
    CALL(vkCreateImageView, fails)                    \
    CALL(vkCreatePipelineCache, fails)                \
    CALL(vkCreatePipelineLayout, fails)               \
    CALL(vkCreateQueryPool, fails)                    \
    CALL(vkCreateRayTracingPipelinesKHR, fails)       \
    CALL(vkCreateSampler, fails)                      \
    CALL(vkCreateSemaphore, fails)                    \
    CALL(vkCreateShaderModule, fails)                 \
    CALL(vkDeviceWaitIdle, loses)                     \
    CALL(vkEndCommandBuffer, fails)                   \
    CALL(vkGetPipelineCacheData, fails)               \
    CALL(vkGetQueryPoolResults, loses)                \
    CALL(vkGetRayTracingShaderGroupHandlesKHR, fails) \
    CALL(vkGetSemaphoreCounterValue, loses)           \
    CALL(vkMapMemory, fails)                          \
    CALL(vkQueueSubmit2, loses)                       \
    CALL(vkResetCommandPool, fails)                   \
    CALL(vkSetDebugUtilsObjectNameEXT, names)         \
    CALL(vkWaitSemaphores, loses)
