// A buffer with its memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/result.h"
#include "rhi/device.h"
#include "rhi/flags.h"

struct VmaAllocation_T;

namespace hm::rhi {

// In addition, every buffer can be copied from and to and has a device address.
enum class BufferUse : std::uint32_t {
    none = 0,
    storage = 1,
    uniform = 2,
    build_input = 4,  // vertices, indices and instances that acceleration structures are built from
    acceleration_structure = 8,
    shader_table = 16,
};
template <>
inline constexpr bool kIsFlags<BufferUse> = true;

enum class MemoryKind {
    device,    // device-local; the host accesses it through copies
    upload,    // the host writes it sequentially and never reads it
    readback,  // the host reads it
};

struct BufferInfo {
    std::string name;
    std::uint64_t size = 0;  // bytes, not 0
    BufferUse use = BufferUse::storage;
    MemoryKind memory = MemoryKind::device;
    std::uint64_t alignment = 0;  // of the device address; 0: the default
};

class Buffer {
  public:
    Buffer() = default;
    // An out-of-memory error says how much was requested and how much is free.
    static Result<Buffer> create(Device& device, const BufferInfo& info);
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Buffer();

    explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }
    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }
    std::uint64_t address() const { return address_; }
    // The mapped memory; empty for MemoryKind::device. Host-coherent, so it needs no flushing.
    std::span<std::byte> mapped() const { return mapped_; }
    VkBuffer handle() const { return handle_; }

  private:
    void swap(Buffer& other) noexcept;

    Device* device_ = nullptr;
    std::string name_;
    VkBuffer handle_ = VK_NULL_HANDLE;
    VmaAllocation_T* allocation_ = nullptr;
    std::uint64_t size_ = 0;
    std::uint64_t address_ = 0;
    std::span<std::byte> mapped_;
};

}  // namespace hm::rhi
