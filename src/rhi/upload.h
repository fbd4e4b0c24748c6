// Copies between host and device through fixed-size staging buffers, so that large scenes need no
// second copy in host-visible memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/result.h"
#include "rhi/buffer.h"
#include "rhi/commands.h"
#include "rhi/image.h"

namespace hm::rhi {

// Double-buffered: while the device copies from one staging buffer, the host fills the other.
class Uploader {
  public:
    // `staging_bytes` is the size of each of the two.
    static Result<Uploader> create(Device& device, std::uint64_t staging_bytes = 32u << 20);

    Result<void> buffer(const Buffer& to, std::span<const std::byte> bytes,
                        std::uint64_t to_offset = 0);
    template <class T>
    Result<void> buffer(const Buffer& to, std::span<const T> values) {
        return buffer(to, std::as_bytes(values));
    }
    // Uploads one mip level as tightly packed rows; leaves it in layout shader_read.
    Result<void> image(const Image& to, std::uint32_t level, std::span<const std::byte> texels);

    // Waits until all copies are complete and visible to shaders and builds.
    Result<void> finish();
    std::uint64_t bytes() const { return bytes_; }

  private:
    struct Half {
        Buffer staging;
        Commands commands;
        Ticket ticket = 0;
        std::uint64_t filled = 0;
    };
    // Reserves space in the current half, or in the next one if the current is full.
    Result<std::span<std::byte>> reserve(std::uint64_t at_least, std::uint64_t at_most);
    std::uint64_t offset_of(std::span<const std::byte> piece) const;  // byte offset in this half
    Result<void> flush();

    Device* device_ = nullptr;
    std::array<Half, 2> halves_;
    std::size_t current_ = 0;
    std::uint64_t bytes_ = 0;
};

// Creates and fills a buffer.
Result<Buffer> upload_buffer(Uploader& uploader, Device& device, const BufferInfo& info,
                             std::span<const std::byte> bytes);

// Waits for all earlier work, then copies bytes back to the host.
Result<void> read_back(Device& device, const Buffer& from, std::span<std::byte> bytes,
                       std::uint64_t from_offset = 0);
// Reads mip level 0 as tightly packed rows; the image stays in `layout` (transfer_source or
// general).
Result<void> read_back(Device& device, const Image& from, ImageLayout layout,
                       std::span<std::byte> texels);

}  // namespace hm::rhi
