#include "rhi/device.h"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <vector>

#include "base/text.h"
#include "rhi/allocator.h"
#include "rhi/commands.h"
#include "rhi/error.h"
#include "rhi/features.h"

namespace hm::rhi {

Result<std::unique_ptr<Device>> Device::create(std::shared_ptr<Instance> instance,
                                               const PhysicalDevice& physical) {
    if (!physical.usable())
        return fail(ErrorKind::no_device, "Vulkan", physical.name,
                    fmt::format("lacks {}", joined(missing(physical.capabilities), ", ")));
    std::unique_ptr<Device> device(new Device);
    device->instance_ = std::move(instance);
    device->physical_ = physical;
    HM_TRY(device->make_device());
    HM_TRY(device->make_allocator());
    HM_TRY(device->make_timeline());
    return device;
}

Device::~Device() {
    if (device_ == VK_NULL_HANDLE) return;
    vkDeviceWaitIdle(device_);
    if (timeline_ != VK_NULL_HANDLE) vkDestroySemaphore(device_, timeline_, nullptr);
    if (allocator_ != nullptr) vmaDestroyAllocator(allocator_);
    vkDestroyDevice(device_, nullptr);
}

Result<void> Device::make_device() {
    acceleration_limits_.sType =
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR;
    ray_tracing_limits_.sType =
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_PROPERTIES_KHR;
    ray_tracing_limits_.pNext = &acceleration_limits_;
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                           .pNext = &ray_tracing_limits_};
    vkGetPhysicalDeviceProperties2(physical_.handle, &properties);
    ray_tracing_limits_.pNext = nullptr;

    std::vector<const char*> extensions;
    for (const Extension& extension : all_extensions())
        if (physical_.has(extension.name)) extensions.push_back(extension.name);
    FeatureChain chain(physical_.has(VK_NV_RAY_TRACING_INVOCATION_REORDER_EXTENSION_NAME));
    for (const Feature& feature : all_features())
        if (physical_.has(feature.name)) feature.field(chain) = VK_TRUE;

    const float priority = 1;
    const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                        .queueFamilyIndex = physical_.queue_family,
                                        .queueCount = 1,
                                        .pQueuePriorities = &priority};
    const VkDeviceCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
        .pNext = &chain.features,
        .queueCreateInfoCount = 1,
        .pQueueCreateInfos = &queue,
        .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
        .ppEnabledExtensionNames = extensions.data()};
    HM_TRY(rhi::check(vkCreateDevice(physical_.handle, &info, nullptr, &device_), "vkCreateDevice",
                      physical_.name));
    vkGetDeviceQueue(device_, physical_.queue_family, 0, &queue_);
    return {};
}

Result<void> Device::make_allocator() {
    const VmaVulkanFunctions functions{.vkGetInstanceProcAddr = vkGetInstanceProcAddr,
                                       .vkGetDeviceProcAddr = vkGetDeviceProcAddr};
    const bool knows_budget = physical_.has(VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
    const VmaAllocatorCreateInfo info{
        .flags = static_cast<VmaAllocatorCreateFlags>(
            VMA_ALLOCATOR_CREATE_BUFFER_DEVICE_ADDRESS_BIT |
            (knows_budget ? VMA_ALLOCATOR_CREATE_EXT_MEMORY_BUDGET_BIT : 0)),
        .physicalDevice = physical_.handle,
        .device = device_,
        .pVulkanFunctions = &functions,
        .instance = instance_->handle(),
        .vulkanApiVersion = VK_API_VERSION_1_3};
    return check(vmaCreateAllocator(&info, &allocator_), "vmaCreateAllocator", physical_.name);
}

Result<void> Device::make_timeline() {
    const VkSemaphoreTypeCreateInfo type{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
                                         .semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE,
                                         .initialValue = 0};
    const VkSemaphoreCreateInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO,
                                     .pNext = &type};
    HM_TRY(check(vkCreateSemaphore(device_, &info, nullptr, &timeline_), "vkCreateSemaphore",
                 "submissions"));
    name(VK_OBJECT_TYPE_SEMAPHORE, timeline_, "submissions");
    return {};
}

MemoryUse Device::memory_use() const {
    const VkPhysicalDeviceMemoryProperties* memory = nullptr;
    vmaGetMemoryProperties(allocator_, &memory);
    std::vector<VmaBudget> budgets(memory->memoryHeapCount);
    vmaGetHeapBudgets(allocator_, budgets.data());
    MemoryUse use;
    for (std::uint32_t i = 0; i < memory->memoryHeapCount; ++i) {
        if ((memory->memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) == 0) continue;
        use.used_bytes += budgets[i].usage;
        use.budget_bytes += budgets[i].budget;
    }
    return use;
}

Result<Ticket> Device::submit(Commands& commands) {
    HM_TRY(commands.end());
    const VkCommandBufferSubmitInfo buffer{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                           .commandBuffer = commands.handle()};
    const VkSemaphoreSubmitInfo signal{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                       .semaphore = timeline_,
                                       .value = submitted_ + 1,
                                       .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    const VkSubmitInfo2 info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                             .commandBufferInfoCount = 1,
                             .pCommandBufferInfos = &buffer,
                             .signalSemaphoreInfoCount = 1,
                             .pSignalSemaphoreInfos = &signal};
    HM_TRY(
        check(vkQueueSubmit2(queue_, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit2", commands.name()));
    commands.ticket_ = ++submitted_;
    return submitted_;
}

Result<void> Device::wait(Ticket ticket) {
    const VkSemaphoreWaitInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
                                   .semaphoreCount = 1,
                                   .pSemaphores = &timeline_,
                                   .pValues = &ticket};
    return check(vkWaitSemaphores(device_, &info, std::numeric_limits<std::uint64_t>::max()),
                 "vkWaitSemaphores", physical_.name);
}

Result<bool> Device::reached(Ticket ticket) const {
    std::uint64_t value = 0;
    HM_TRY(check(vkGetSemaphoreCounterValue(device_, timeline_, &value),
                 "vkGetSemaphoreCounterValue", physical_.name));
    return value >= ticket;
}

Result<void> Device::wait_idle() {
    return check(vkDeviceWaitIdle(device_), "vkDeviceWaitIdle", physical_.name);
}

Error Device::error(VkResult result, std::string_view call, std::string_view object) const {
    // A lost device no longer uses anything; if waiting fails too, nothing more can be done.
    vkDeviceWaitIdle(device_);
    return device_error(result, call, object);
}

void Device::set_name(VkObjectType type, std::uint64_t handle, std::string_view name) const {
    if (!instance_->names_objects()) return;
    const std::string text(name);
    const VkDebugUtilsObjectNameInfoEXT info{
        .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
        .objectType = type,
        .objectHandle = handle,
        .pObjectName = text.c_str()};
    // Names are a convenience: ignore drivers that cannot store them.
    vkSetDebugUtilsObjectNameEXT(device_, &info);
}

}  // namespace hm::rhi
