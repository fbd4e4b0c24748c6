// The Vulkan headers without prototypes. volk opens the loader at run time, so a program that links
// this starts even if no loader is installed. volk's function pointers are global and dispatch
// through the loader, so they work for several devices at once.
#pragma once

#include <volk.h>

#include <utility>

namespace hm::rhi {

// Owns one object made from a VkDevice. `Destroy` is the address of volk's vkDestroy* pointer.
template <class T, auto Destroy>
class Handle {
  public:
    Handle() = default;
    Handle(VkDevice device, T handle) : device_(device), handle_(handle) {}
    Handle(Handle&& other) noexcept
        : device_(other.device_), handle_(std::exchange(other.handle_, VK_NULL_HANDLE)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Handle() {
        if (handle_ != VK_NULL_HANDLE) (*Destroy)(device_, handle_, nullptr);
    }
    T get() const { return handle_; }

  private:
    VkDevice device_ = VK_NULL_HANDLE;
    T handle_ = VK_NULL_HANDLE;
};

}  // namespace hm::rhi
