// The Vulkan loader, opened at run time, and an instance of it; with validation when asked.
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
    // The Khronos validation layer with synchronisation validation; an error where it is missing.
    bool validation = validation_wanted();
    std::string loader = "libvulkan.so.1";

    // Whether the environment says HIMALAYA_VALIDATION=1.
    static bool validation_wanted();
};

// Shared by the devices made from it. volk's functions are those of the last loader opened.
class Instance {
  public:
    // Fails with ErrorKind::no_device where there is no loader or no driver.
    static Result<std::shared_ptr<Instance>> create(const InstanceOptions& options = {});
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    // In the loader's order: the N of vulkan:N. Makes no VkDevice. Empty where no driver answers.
    Result<std::vector<PhysicalDevice>> devices() const;

    bool validates() const { return messenger_ != VK_NULL_HANDLE; }
    bool names_objects() const { return names_objects_; }
    // Messages of the validation layer. The destructor prints those that nobody took.
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
