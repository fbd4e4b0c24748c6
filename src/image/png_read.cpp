// Reads PNG with Wuffs (W3C, Portable Network Graphics, third edition), which is two to three times
// as fast as libspng (docs/decisions/0011-png-by-wuffs.md).
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/memory.h"
#include "image/big_endian.h"
#include "image/codecs.h"
#include "image/wuffs.h"

namespace hm {
namespace {

tl::unexpected<Error> refuse(std::string_view name, std::string message) {
    return fail(ErrorKind::invalid, std::string(name), "", "PNG: " + std::move(message));
}

// Wuffs' messages are like "#png: bad checksum", "#deflate: bad distance".
tl::unexpected<Error> refuse(std::string_view name, wuffs_base__status status) {
    std::string_view message = status.message();
    if (message.starts_with("png: ")) message.remove_prefix(5);
    return refuse(name, std::string(message));
}

wuffs_base__slice_u8 slice(std::span<std::byte> bytes) {
    return wuffs_base__make_slice_u8(reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size());
}

// Wuffs has no const slices.
wuffs_base__slice_u8 read_only(Bytes bytes) {
    auto* first = reinterpret_cast<std::uint8_t*>(const_cast<std::byte*>(bytes.data()));
    return wuffs_base__make_slice_u8(first, bytes.size());
}

std::uint32_t checksum(Bytes bytes) {
    const wuffs_crc32__ieee_hasher::unique_ptr hasher = wuffs_crc32__ieee_hasher::alloc();
    if (!hasher) throw std::bad_alloc();
    return hasher->update_u32(read_only(bytes));
}

struct Chunk {
    std::string_view type;
    Bytes data;
    bool intact;
};

std::string_view chunk_type(Bytes chunk) {
    return {reinterpret_cast<const char*>(chunk.data()) + 4, 4};
}

// Removes the first chunk from `rest`; nullopt at the end or if the chunk is truncated.
std::optional<Chunk> next_chunk(Bytes& rest) {
    constexpr std::size_t kFrame = 12;  // length, type, checksum
    if (rest.size() < kFrame) return std::nullopt;
    const std::size_t length = big_endian(rest.first(4));
    if (length > rest.size() - kFrame) return std::nullopt;
    const Bytes summed = rest.subspan(4, 4 + length);
    const std::string_view type = chunk_type(rest);
    Chunk chunk{type, summed.subspan(4), true};
    if (type != "IDAT")  // large, and checked by the decoder
        chunk.intact = checksum(summed) == big_endian(rest.subspan(8 + length, 4));
    rest = rest.subspan(kFrame + length);
    return chunk;
}

// Information needed before decoding, or not reported by the decoder.
struct Header {
    std::uint64_t width = 0, height = 0;
    std::uint64_t depth = 0;
    std::uint64_t color_type = 0;
    Bytes transparent;  // the contents of tRNS
    bool animated = false;
    bool intact = true;  // checksum of tRNS, which the decoder ignores
};

constexpr std::uint64_t kGrey = 0, kTruecolour = 2;
constexpr std::size_t kSignatureBytes = 8;

constexpr std::uint64_t kChannels[] = {1, 0, 3, 1, 2, 0, 4};  // by colour type; 0: invalid type

// Fails if IHDR is missing, damaged or requires too much memory; other faults are left to the
// decoder.
Result<Header> read_header(Bytes png, std::string_view name) {
    Bytes rest = png.subspan(std::min(png.size(), kSignatureBytes));
    const std::optional<Chunk> first = next_chunk(rest);
    if (!first || first->type != "IHDR" || first->data.size() != 13 || !first->intact)
        return refuse(name, "invalid IHDR chunk");
    Header header;
    header.width = big_endian(first->data.subspan(0, 4));
    header.height = big_endian(first->data.subspan(4, 4));
    header.depth = big_endian(first->data.subspan(8, 1));
    header.color_type = big_endian(first->data.subspan(9, 1));
    if (header.color_type >= std::size(kChannels) || kChannels[header.color_type] == 0 ||
        header.depth > 16)
        return refuse(name, "invalid IHDR chunk");
    HM_TRY(check_image_size(header.width, header.height, name));
    // Deflate expands a byte to at most 1032 (two bits for a run of 258).
    const std::uint64_t bits = kChannels[header.color_type] * header.depth;
    if (header.width * header.height * bits / 8 > png.size() * 1032)
        return refuse(name, fmt::format("{} bytes are too few for {} x {} pixels", png.size(),
                                        header.width, header.height));
    while (const std::optional<Chunk> chunk = next_chunk(rest)) {
        if (chunk->type == "tRNS") {
            header.intact = header.intact && chunk->intact;
            if (header.transparent.empty()) header.transparent = chunk->data;
        }
        if (chunk->type == "acTL") header.animated = true;
        if (chunk->type == "IEND") break;
    }
    return header;
}

// Whether the checksums of all critical chunks are correct; IEND may be missing.
bool critical_chunks_intact(Bytes png) {
    Bytes rest = png.subspan(kSignatureBytes), before = rest;
    while (const std::optional<Chunk> chunk = next_chunk(rest)) {
        const bool critical = chunk->type[0] >= 'A' && chunk->type[0] <= 'Z';
        const Bytes summed = before.subspan(4, 4 + chunk->data.size());
        if (chunk->type == "IEND") return true;
        if (critical && checksum(summed) != big_endian(before.subspan(4 + summed.size(), 4)))
            return false;
        before = rest;
    }
    constexpr std::size_t kEmptyChunk = 12;
    return rest.size() < 8 || (rest.size() <= kEmptyChunk && chunk_type(rest) == "IEND");
}

// The file without its animation chunks. Textures use the still image, which may differ from the
// first animation frame, which the decoder would return.
std::vector<std::byte> without_animation(Bytes png) {
    std::vector<std::byte> still(png.begin(), png.begin() + kSignatureBytes);
    Bytes rest = png.subspan(kSignatureBytes), chunk_and_rest = rest;
    while (const std::optional<Chunk> chunk = next_chunk(rest)) {
        const Bytes whole = chunk_and_rest.first(chunk_and_rest.size() - rest.size());
        chunk_and_rest = rest;
        if (chunk->type == "acTL" || chunk->type == "fcTL" || chunk->type == "fdAT") continue;
        still.insert(still.end(), whole.begin(), whole.end());
    }
    still.insert(still.end(), rest.begin(), rest.end());
    return still;
}

// The decoder writes black for pixels of the colour that tRNS makes transparent, but materials may
// ignore alpha.
template <class T>
void restore_transparent_colour(const Header& header, ImageOf<T>& image) {
    const bool grey = header.color_type == kGrey;
    if (!grey && header.color_type != kTruecolour) return;
    if (header.transparent.size() != (grey ? 2u : 6u)) return;
    const std::uint64_t most = (1u << header.depth) - 1;
    T color[3];
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint64_t value = big_endian(header.transparent.subspan(grey ? 0 : 2 * c, 2));
        color[c] = T(header.depth < 8 ? (value & most) * 255 / most : value & most);
    }
    for (Rgba<T>& pixel : image.pixels)
        if (pixel[3] == 0) std::copy(color, color + 3, pixel.begin());
}

// Decodes the image, then reads to the end of the file to check that it is complete.
template <class T>
Result<ImageOf<T>> decode_pixels(wuffs_png__decoder& decoder, wuffs_base__io_buffer& source,
                                 wuffs_base__image_config config, std::uint32_t format,
                                 std::string_view name) {
    ImageOf<T> image(config.pixcfg.width(), config.pixcfg.height());
    // Work buffer: the decoder keeps all filtered rows until it writes pixels.
    ByteArray stored(decoder.workbuf_len().min_incl);
    config.pixcfg.set(format, WUFFS_BASE__PIXEL_SUBSAMPLING__NONE, image.width, image.height);
    wuffs_base__pixel_buffer pixels{};
    wuffs_base__status status = pixels.set_from_slice(
        &config.pixcfg, slice(std::as_writable_bytes(std::span(image.pixels))));
    if (status.is_ok())
        status = decoder.decode_frame(&pixels, &source, WUFFS_BASE__PIXEL_BLEND__SRC, slice(stored),
                                      nullptr);
    while (status.is_ok())
        status = decoder.decode_frame_config(nullptr, &source);
    if (status.repr != wuffs_base__note__end_of_data) return refuse(name, status);
    return image;
}

Result<TextureImage> decode(Bytes bytes, const Header& header, std::string_view name) {
    if (!header.intact) return refuse(name, "bad checksum");
    std::vector<std::byte> still;
    if (header.animated) {
        still = without_animation(bytes);
        bytes = still;
    }
    const wuffs_png__decoder::unique_ptr decoder = wuffs_png__decoder::alloc();
    if (!decoder) throw std::bad_alloc();
    wuffs_base__io_buffer source = wuffs_base__slice_u8__reader(read_only(bytes), true);
    wuffs_base__image_config config{};
    const wuffs_base__status status = decoder->decode_image_config(&config, &source);
    if (!status.is_ok()) return refuse(name, status);

    if (header.depth == 16) {
        // The only 16-bit format that the decoder writes.
        HM_TRY_ASSIGN(Image16 image, decode_pixels<std::uint16_t>(
                                         *decoder, source, config,
                                         WUFFS_BASE__PIXEL_FORMAT__BGRA_NONPREMUL_4X16LE, name));
        for (Rgba<std::uint16_t>& pixel : image.pixels)
            std::swap(pixel[0], pixel[2]);
        restore_transparent_colour(header, image);
        return image;
    }
    HM_TRY_ASSIGN(Image8 image,
                  decode_pixels<std::uint8_t>(*decoder, source, config,
                                              WUFFS_BASE__PIXEL_FORMAT__RGBA_NONPREMUL, name));
    restore_transparent_colour(header, image);
    return image;
}

}  // namespace

Result<TextureImage> decode_png(Bytes bytes, std::string_view name, ReadWarnings& warnings) {
    HM_TRY_ASSIGN(const Header header, read_header(bytes, name));
    Result<TextureImage> image = decode(bytes, header, name);
    if (image || !critical_chunks_intact(bytes)) return image;
    Result<TextureImage> lenient = decode_png_leniently(bytes, header.depth == 16);
    if (!lenient) return image;
    warnings.push_back(image.error().message + "; all pixels are intact");
    return lenient;
}

}  // namespace hm
