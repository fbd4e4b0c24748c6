#include "rhi/buffer.h"

#include <utility>

#include "base/check.h"
#include "rhi/memory.h"

namespace hm::rhi {

namespace {

VkBufferUsageFlags usage_of(BufferUse use) {
    VkBufferUsageFlags flags = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                               VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
    if (has(use, BufferUse::storage)) flags |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    if (has(use, BufferUse::uniform)) flags |= VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
    if (has(use, BufferUse::build_input))
        flags |= VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;
    if (has(use, BufferUse::acceleration_structure))
        flags |= VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR;
    if (has(use, BufferUse::shader_table)) flags |= VK_BUFFER_USAGE_SHADER_BINDING_TABLE_BIT_KHR;
    return flags;
}

}  // namespace

Result<Buffer> Buffer::create(Device& device, const BufferInfo& info) {
    HM_CHECK(info.size > 0, "buffer {}", info.name);
    // Drivers are not required to reject such sizes.
    if (info.size > device.limits().max_buffer_bytes ||
        (info.memory == MemoryKind::device && info.size > device.memory_use().budget_bytes))
        return tl::unexpected(memory_error(device, VK_ERROR_OUT_OF_DEVICE_MEMORY, "vkCreateBuffer",
                                           info.name, info.size));
    Buffer buffer;
    buffer.device_ = &device;
    buffer.name_ = info.name;
    buffer.size_ = info.size;
    const VkBufferCreateInfo create{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                    .size = info.size,
                                    .usage = usage_of(info.use)};
    const VmaAllocationCreateInfo allocate = allocation_info(info.memory);
    VmaAllocationInfo allocated{};
    const VkResult result =
        vmaCreateBufferWithAlignment(device.allocator(), &create, &allocate, info.alignment,
                                     &buffer.handle_, &buffer.allocation_, &allocated);
    if (result != VK_SUCCESS)
        return tl::unexpected(
            memory_error(device, result, "vmaCreateBuffer", info.name, info.size));
    device.name(VK_OBJECT_TYPE_BUFFER, buffer.handle_, info.name);
    vmaSetAllocationName(device.allocator(), buffer.allocation_, info.name.c_str());
    if (allocated.pMappedData != nullptr && info.memory != MemoryKind::device)
        buffer.mapped_ = {static_cast<std::byte*>(allocated.pMappedData), info.size};
    const VkBufferDeviceAddressInfo address{.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO,
                                            .buffer = buffer.handle_};
    buffer.address_ = vkGetBufferDeviceAddress(device.handle(), &address);
    return buffer;
}

Buffer::~Buffer() {
    if (handle_ != VK_NULL_HANDLE) vmaDestroyBuffer(device_->allocator(), handle_, allocation_);
}

void Buffer::swap(Buffer& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(name_, other.name_);
    std::swap(handle_, other.handle_);
    std::swap(allocation_, other.allocation_);
    std::swap(size_, other.size_);
    std::swap(address_, other.address_);
    std::swap(mapped_, other.mapped_);
}

}  // namespace hm::rhi
