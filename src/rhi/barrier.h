// A memory barrier as plain data: what must complete before what may begin. The render graph
// computes barriers without a device.
#pragma once

#include <cstdint>

#include "rhi/image.h"

namespace hm::rhi {

// Pipeline stages and access types, as Vulkan's VkPipelineStageFlagBits2 and VkAccessFlagBits2.
struct Scope {
    std::uint64_t stages = 0;
    std::uint64_t access = 0;

    bool operator==(const Scope&) const = default;
};

inline constexpr Scope kEverything{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                   VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};

struct Barrier {
    Scope before;
    Scope after;
    // Null: all memory. Otherwise this image, changing its layout where `from` and `to` differ.
    const Image* image = nullptr;
    ImageLayout from = ImageLayout::undefined;
    ImageLayout to = ImageLayout::undefined;
};

}  // namespace hm::rhi
