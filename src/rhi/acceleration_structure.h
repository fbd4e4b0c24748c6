// What rays search: a bottom-level structure over triangles, or a top-level one over instances.
// acceleration_build.h makes them.
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "rhi/buffer.h"
#include "rhi/device.h"

namespace hm::rhi {

class AccelerationStructure {
  public:
    AccelerationStructure() = default;
    explicit operator bool() const { return handle_.get() != VK_NULL_HANDLE; }
    std::uint64_t address() const { return address_; }  // what an instance refers to
    std::uint64_t bytes() const { return buffer_.size(); }
    VkAccelerationStructureKHR handle() const { return handle_.get(); }

    // Memory for a structure of that many bytes; a build or a copy fills it.
    static Result<AccelerationStructure> allocate(Device& device, const std::string& name,
                                                  VkAccelerationStructureTypeKHR type,
                                                  std::uint64_t bytes);

  private:
    Buffer buffer_;
    Handle<VkAccelerationStructureKHR, &vkDestroyAccelerationStructureKHR> handle_;
    std::uint64_t address_ = 0;
};

}  // namespace hm::rhi
