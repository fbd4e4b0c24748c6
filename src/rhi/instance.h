// The Vulkan loader, opened at run time, and an instance, optionally with validation.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "rhi/messages.h"
#include "rhi/physical_device.h"
#include "rhi/vulkan.h"

namespace hm::rhi {

struct InstanceOptions {
    // Enables the Khronos validation layer with synchronisation validation; an error if missing.
    bool validation = validation_wanted();
    std::string loader = "libvulkan.so.1";

    // Whether the environment variable HIMALAYA_VALIDATION is 1.
    static bool validation_wanted();
};

// Shared by the devices created from it. volk's functions are those of the last loader opened.
class Instance {
  public:
    // Fails with ErrorKind::no_device if there is no loader or no driver.
    static Result<std::shared_ptr<Instance>> create(const InstanceOptions& options = {});
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    // In the loader's order: index N is vulkan:N. Creates no VkDevice. Empty if there is no driver.
    Result<std::vector<PhysicalDevice>> devices() const;

    bool validates() const { return messenger_ != VK_NULL_HANDLE; }
    bool names_objects() const { return names_objects_; }
    // Messages of the validation layer. The destructor prints those that were not fetched.
    Messages& messages() { return messages_; }
    VkInstance handle() const { return instance_; }

  private:
    Instance() = default;

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    bool names_objects_ = false;
    Messages messages_;
};

}  // namespace hm::rhi
