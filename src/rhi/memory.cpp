#include "rhi/memory.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

#include "rhi/memory_block.h"

namespace hm::rhi {

namespace {

// "1.5 GiB", "16 B"
std::string size_text(std::uint64_t bytes) {
    constexpr std::array<const char*, 6> kUnits = {"B", "KiB", "MiB", "GiB", "TiB", "PiB"};
    auto size = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; size >= 1024 && unit + 1 < kUnits.size(); ++unit)
        size /= 1024;
    return fmt::format("{:.3g} {}", size, kUnits[unit]);
}

}  // namespace

VmaAllocationCreateInfo allocation_info(MemoryKind kind) {
    VmaAllocationCreateInfo info{};
    info.usage = VMA_MEMORY_USAGE_AUTO;
    switch (kind) {
        case MemoryKind::device:
            // Without this, drivers move memory to the host instead of failing, and the allocator
            // falls back to host memory: much slower, and silently.
            info.flags = VMA_ALLOCATION_CREATE_WITHIN_BUDGET_BIT;
            info.usage = VMA_MEMORY_USAGE_AUTO_PREFER_DEVICE;
            info.requiredFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
            break;
        case MemoryKind::upload:
            info.flags = VMA_ALLOCATION_CREATE_MAPPED_BIT |
                         VMA_ALLOCATION_CREATE_HOST_ACCESS_SEQUENTIAL_WRITE_BIT;
            info.usage = VMA_MEMORY_USAGE_AUTO_PREFER_HOST;
            info.requiredFlags = VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
            break;
        case MemoryKind::readback:
            info.flags =
                VMA_ALLOCATION_CREATE_MAPPED_BIT | VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT;
            info.usage = VMA_MEMORY_USAGE_AUTO_PREFER_HOST;
            info.requiredFlags = VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
            break;
    }
    return info;
}

Error memory_error(const Device& device, VkResult result, std::string_view call,
                   std::string_view object, std::uint64_t bytes) {
    Error error = device.error(result, call, object);
    if (result != VK_ERROR_OUT_OF_DEVICE_MEMORY) return error;
    const MemoryUse use = device.memory_use();
    error.message += fmt::format(": {} were requested, {} of {} are in use", size_text(bytes),
                                 size_text(use.used_bytes), size_text(use.budget_bytes));
    return error;
}

Result<MemoryBlock> MemoryBlock::create(Device& device, const std::string& name,
                                        const MemoryNeeds& needs) {
    MemoryBlock block;
    block.device_ = &device;
    const VkMemoryRequirements requirements{needs.bytes, needs.alignment, needs.types};
    // VMA needs explicit memory properties here.
    VmaAllocationCreateInfo info{};
    info.flags = VMA_ALLOCATION_CREATE_WITHIN_BUDGET_BIT;
    info.requiredFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    const VkResult result =
        vmaAllocateMemory(device.allocator(), &requirements, &info, &block.allocation_, nullptr);
    if (result != VK_SUCCESS)
        return tl::unexpected(memory_error(device, result, "vmaAllocateMemory", name, needs.bytes));
    vmaSetAllocationName(device.allocator(), block.allocation_, name.c_str());
    return block;
}

MemoryBlock::~MemoryBlock() {
    if (allocation_ != nullptr) vmaFreeMemory(device_->allocator(), allocation_);
}

void MemoryBlock::swap(MemoryBlock& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(allocation_, other.allocation_);
}

}  // namespace hm::rhi
