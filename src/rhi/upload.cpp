#include "rhi/upload.h"

#include <algorithm>
#include <cstring>

#include "base/check.h"
#include "rhi/error.h"

namespace hm::rhi {

namespace {

// Enough for the start of a copy into an image of any format.
constexpr std::uint64_t kAlignment = 16;

std::uint64_t aligned(std::uint64_t offset) {
    return (offset + kAlignment - 1) / kAlignment * kAlignment;
}

}  // namespace

Result<Uploader> Uploader::create(Device& device, std::uint64_t staging_bytes) {
    Uploader uploader;
    uploader.device_ = &device;
    for (Half& half : uploader.halves_) {
        HM_TRY_ASSIGN(half.staging, Buffer::create(device, {.name = "upload staging",
                                                            .size = staging_bytes,
                                                            .use = BufferUse::none,
                                                            .memory = MemoryKind::upload}));
        HM_TRY_ASSIGN(half.commands, Commands::begin(device, "upload"));
    }
    uploader.halves_[0].commands.full_barrier();
    return uploader;
}

Result<std::span<std::byte>> Uploader::reserve(std::uint64_t at_least, std::uint64_t at_most) {
    Half* half = &halves_[current_];
    HM_CHECK(at_least <= half->staging.size(), "{} bytes in one piece, staging has {}", at_least,
             half->staging.size());
    if (aligned(half->filled) + at_least > half->staging.size()) {
        HM_TRY(flush());
        half = &halves_[current_];
    }
    const std::uint64_t begin = aligned(half->filled);
    const std::uint64_t size = std::min(at_most, half->staging.size() - begin);
    half->filled = begin + size;
    bytes_ += size;
    return half->staging.mapped().subspan(begin, size);
}

Result<void> Uploader::flush() {
    Half& full = halves_[current_];
    HM_TRY_ASSIGN(full.ticket, device_->submit(full.commands));
    current_ = 1 - current_;
    Half& next = halves_[current_];
    HM_TRY(device_->wait(next.ticket));
    HM_TRY(next.commands.begin_again());
    // Two uploads to the same destination complete in order.
    next.commands.full_barrier();
    next.filled = 0;
    return {};
}

std::uint64_t Uploader::offset_of(std::span<const std::byte> piece) const {
    return static_cast<std::uint64_t>(piece.data() - halves_[current_].staging.mapped().data());
}

Result<void> Uploader::buffer(const Buffer& to, std::span<const std::byte> bytes,
                              std::uint64_t to_offset) {
    HM_CHECK(to_offset + bytes.size() <= to.size(), "{} bytes at {} of {}", bytes.size(), to_offset,
             to.size());
    while (!bytes.empty()) {
        HM_TRY_ASSIGN(const std::span<std::byte> piece, reserve(1, bytes.size()));
        std::memcpy(piece.data(), bytes.data(), piece.size());
        Half& half = halves_[current_];
        half.commands.copy(half.staging, to, offset_of(piece), to_offset, piece.size());
        bytes = bytes.subspan(piece.size());
        to_offset += piece.size();
    }
    return {};
}

Result<void> Uploader::image(const Image& to, std::uint32_t level,
                             std::span<const std::byte> texels) {
    const std::uint32_t width = std::max(1u, to.info().width >> level);
    const std::uint32_t height = std::max(1u, to.info().height >> level);
    const std::uint64_t row_bytes = std::uint64_t{width} * bytes_per_texel(to.info().format);
    HM_CHECK(texels.size() == row_bytes * height, "image {}: {} bytes for {} x {}", to.info().name,
             texels.size(), width, height);
    // As many rows at a time as fit.
    for (std::uint32_t row = 0; row < height;) {
        HM_TRY_ASSIGN(std::span<std::byte> piece, reserve(row_bytes, texels.size()));
        const auto rows = static_cast<std::uint32_t>(piece.size() / row_bytes);
        piece = piece.first(rows * row_bytes);
        std::memcpy(piece.data(), texels.data(), piece.size());
        Half& half = halves_[current_];
        const ImageRows target{level, row, rows, width};
        half.commands.copy(half.staging, offset_of(piece), to, target, row == 0,
                           row + rows == height);
        texels = texels.subspan(piece.size());
        row += rows;
    }
    return {};
}

Result<void> Uploader::finish() {
    halves_[current_].commands.full_barrier();
    HM_TRY(flush());
    return device_->wait(halves_[1 - current_].ticket);
}

Result<Buffer> upload_buffer(Uploader& uploader, Device& device, const BufferInfo& info,
                             std::span<const std::byte> bytes) {
    HM_TRY_ASSIGN(Buffer buffer, Buffer::create(device, info));
    HM_TRY(uploader.buffer(buffer, bytes));
    return buffer;
}

namespace {

Result<void> bring_back(Device& device, std::span<std::byte> bytes,
                        const std::function<void(Commands&, const Buffer&)>& copy) {
    HM_TRY_ASSIGN(const Buffer staging, Buffer::create(device, {.name = "read back",
                                                                .size = bytes.size(),
                                                                .use = BufferUse::none,
                                                                .memory = MemoryKind::readback}));
    HM_TRY(run_once(device, "read back", [&](Commands& commands) -> Result<void> {
        commands.full_barrier();
        copy(commands, staging);
        return {};
    }));
    std::memcpy(bytes.data(), staging.mapped().data(), bytes.size());
    return {};
}

}  // namespace

Result<void> read_back(Device& device, const Buffer& from, std::span<std::byte> bytes,
                       std::uint64_t from_offset) {
    return bring_back(device, bytes, [&](Commands& commands, const Buffer& staging) {
        commands.copy(from, staging, from_offset, 0, bytes.size());
    });
}

Result<void> read_back(Device& device, const Image& from, ImageLayout layout,
                       std::span<std::byte> texels) {
    return bring_back(device, texels, [&](Commands& commands, const Buffer& staging) {
        commands.copy(from, layout, staging);
    });
}

}  // namespace hm::rhi
