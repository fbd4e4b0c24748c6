// A Vulkan device with all features that we use enabled, its only queue and its memory allocator.
//
// All objects of this folder are created from a Device and must not outlive it. None is
// thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "base/result.h"
#include "rhi/instance.h"
#include "rhi/physical_device.h"
#include "rhi/vulkan.h"

// Forward declaration, to avoid including the allocator's large header here.
struct VmaAllocator_T;

namespace hm::rhi {

class Commands;

// The value that the queue's timeline semaphore reaches when a submission is complete.
using Ticket = std::uint64_t;

struct MemoryUse {
    std::uint64_t used_bytes = 0;    // device-local memory used by this process
    std::uint64_t budget_bytes = 0;  // what the driver allows this process, including what it uses
};

class Device {
  public:
    // Fails with ErrorKind::no_device if `physical` lacks something required.
    static Result<std::unique_ptr<Device>> create(std::shared_ptr<Instance> instance,
                                                  const PhysicalDevice& physical);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const PhysicalDevice& physical() const { return physical_; }
    const Limits& limits() const { return physical_.limits; }
    Instance& instance() const { return *instance_; }
    MemoryUse memory_use() const;

    // Submits recorded commands to the queue. Submissions start in order, but their work may
    // overlap unless barriers order it. `commands` must live until its ticket is reached.
    Result<Ticket> submit(Commands& commands);
    // Blocks until the ticket's work is done and its writes are visible to the host.
    Result<void> wait(Ticket ticket);
    Result<bool> reached(Ticket ticket) const;
    Result<void> wait_idle();

    // The error for a failed call (see error.h); `object` names what was created or used. Waits
    // until the device is idle, so that all objects may be destroyed in any order.
    Error error(VkResult result, std::string_view call, std::string_view object) const;
    Result<void> check(VkResult result, std::string_view call, std::string_view object) const {
        if (result >= 0) return {};
        return tl::unexpected(error(result, call, object));
    }

    // The object's name in debuggers and validation messages.
    template <class T>
    void name(VkObjectType type, T handle, std::string_view name) const {
        set_name(type, reinterpret_cast<std::uint64_t>(handle), name);
    }

    VkDevice handle() const { return device_; }
    VmaAllocator_T* allocator() const { return allocator_; }
    // Alignments of acceleration structure scratch memory and of the shader binding table.
    const VkPhysicalDeviceAccelerationStructurePropertiesKHR& acceleration_limits() const {
        return acceleration_limits_;
    }
    const VkPhysicalDeviceRayTracingPipelinePropertiesKHR& ray_tracing_limits() const {
        return ray_tracing_limits_;
    }

  private:
    Device() = default;
    Result<void> make_device();
    Result<void> make_allocator();
    Result<void> make_timeline();
    void set_name(VkObjectType type, std::uint64_t handle, std::string_view name) const;

    std::shared_ptr<Instance> instance_;
    PhysicalDevice physical_;
    VkPhysicalDeviceAccelerationStructurePropertiesKHR acceleration_limits_{};
    VkPhysicalDeviceRayTracingPipelinePropertiesKHR ray_tracing_limits_{};
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    VmaAllocator_T* allocator_ = nullptr;
    VkSemaphore timeline_ = VK_NULL_HANDLE;
    Ticket submitted_ = 0;
};

}  // namespace hm::rhi
