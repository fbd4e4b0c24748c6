// Acceleration structures for ray tracing: bottom-level ones over triangles, top-level ones over
// instances. acceleration_build.h builds them.
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
    std::uint64_t address() const { return address_; }  // device address, for TlasInstance::blas
    std::uint64_t bytes() const { return buffer_.size(); }
    VkAccelerationStructureKHR handle() const { return handle_.get(); }

    // Allocates memory for a structure of that many bytes; a build or a copy fills it.
    static Result<AccelerationStructure> allocate(Device& device, const std::string& name,
                                                  VkAccelerationStructureTypeKHR type,
                                                  std::uint64_t bytes);

  private:
    Buffer buffer_;
    Handle<VkAccelerationStructureKHR, &vkDestroyAccelerationStructureKHR> handle_;
    std::uint64_t address_ = 0;
};

}  // namespace hm::rhi
