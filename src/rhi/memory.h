// How memory is allocated, and the error when there is not enough.
#pragma once

#include <cstdint>
#include <string_view>

#include "rhi/allocator.h"
#include "rhi/buffer.h"
#include "rhi/device.h"
#include "rhi/error.h"

namespace hm::rhi {

VmaAllocationCreateInfo allocation_info(MemoryKind kind);

// device_error(); for out-of-memory errors it adds the requested size and the free memory.
Error memory_error(const Device& device, VkResult result, std::string_view call,
                   std::string_view object, std::uint64_t bytes);

}  // namespace hm::rhi
