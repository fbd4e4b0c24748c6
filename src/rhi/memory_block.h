// A block of device memory that several images may share, side by side or aliased.
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "rhi/device.h"

struct VmaAllocation_T;

namespace hm::rhi {

struct ImageInfo;

struct MemoryNeeds {
    std::uint64_t bytes = 0;
    std::uint64_t alignment = 1;
    std::uint32_t types = ~0u;  // a bit for each suitable memory type of the device
};

// The memory requirements of an image that is not created yet.
MemoryNeeds memory_needs(const Device& device, const ImageInfo& info);

class MemoryBlock {
  public:
    MemoryBlock() = default;
    static Result<MemoryBlock> create(Device& device, const std::string& name,
                                      const MemoryNeeds& needs);
    MemoryBlock(MemoryBlock&& other) noexcept { swap(other); }
    MemoryBlock& operator=(MemoryBlock&& other) noexcept {
        swap(other);
        return *this;
    }
    ~MemoryBlock();
    VmaAllocation_T* allocation() const { return allocation_; }

  private:
    void swap(MemoryBlock& other) noexcept;

    Device* device_ = nullptr;
    VmaAllocation_T* allocation_ = nullptr;
};

}  // namespace hm::rhi
