// Reading PNG through Wuffs (W3C, Portable Network Graphics, third edition). It was two to three
// times as fast as libspng on the textures of shared scenes.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "image/big_endian.h"
#include "image/codecs.h"
#include "image/wuffs.h"

namespace hm {
namespace {

tl::unexpected<Error> refuse(std::string_view name, std::string message) {
    return fail(ErrorKind::invalid, std::string(name), "", "PNG: " + std::move(message));
}

// Wuffs says "#png: bad checksum", "#deflate: bad distance".
tl::unexpected<Error> refuse(std::string_view name, wuffs_base__status status) {
    std::string_view message = status.message();
    if (message.starts_with("png: ")) message.remove_prefix(5);
    return refuse(name, std::string(message));
}

wuffs_base__slice_u8 slice(std::span<std::byte> bytes) {
    return wuffs_base__make_slice_u8(reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size());
}

// Wuffs has no slices of constant bytes.
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

// The first chunk of `rest`, which is moved on behind it; nothing at the end or where one is cut.
std::optional<Chunk> next_chunk(Bytes& rest) {
    constexpr std::size_t kFrame = 12;  // length, type, checksum
    if (rest.size() < kFrame) return std::nullopt;
    const std::size_t length = big_endian(rest.first(4));
    if (length > rest.size() - kFrame) return std::nullopt;
    const Bytes summed = rest.subspan(4, 4 + length);
    const std::string_view type(reinterpret_cast<const char*>(summed.data()), 4);
    Chunk chunk{type, summed.subspan(4), true};
    if (type != "IDAT")  // those are many bytes, and the decoder checks them
        chunk.intact = checksum(summed) == big_endian(rest.subspan(8 + length, 4));
    rest = rest.subspan(kFrame + length);
    return chunk;
}

// What the decoder does not tell.
struct Header {
    std::uint64_t depth = 0;
    std::uint64_t color_type = 0;
    bool interlaced = false;
    Bytes transparent;               // the contents of tRNS
    std::size_t animation_type = 0;  // where acTL has its type; 0 without
};

constexpr std::uint64_t kGrey = 0, kTruecolour = 2;

// Fails where a chunk that the decoder passes over is damaged; leaves other faults to the decoder.
Result<Header> read_header(Bytes png, std::string_view name) {
    constexpr std::size_t kSignature = 8, kDepth = 24, kColorType = 25,
                          kInterlace = 28;  // IHDR is first (5.6)
    Header header;
    if (png.size() <= kInterlace) return header;
    header.depth = big_endian(png.subspan(kDepth, 1));
    header.color_type = big_endian(png.subspan(kColorType, 1));
    header.interlaced = png[kInterlace] != std::byte(0);
    Bytes rest = png.subspan(kSignature);
    while (const std::optional<Chunk> chunk = next_chunk(rest)) {
        if (!chunk->intact) return refuse(name, "bad checksum");
        if (chunk->type == "tRNS" && header.transparent.empty()) header.transparent = chunk->data;
        if (chunk->type == "acTL" && header.animation_type == 0)
            header.animation_type = std::size_t(chunk->data.data() - png.data()) - 4;
        if (chunk->type == "IEND") break;
    }
    return header;
}

std::uint64_t bits_per_pixel(const Header& header) {
    constexpr std::uint64_t kChannels[] = {1, 0, 3, 1, 2, 0, 4};  // by colour type
    return kChannels[header.color_type] * header.depth;
}

// Of 16 bits the decoder writes no other order.
void exchange_red_and_blue(std::span<std::byte> pixels) {
    auto* numbers = reinterpret_cast<std::uint16_t*>(pixels.data());
    for (std::size_t i = 0; i < pixels.size() / 2; i += 4)
        std::swap(numbers[i], numbers[i + 2]);
}

// Pixels of the one colour that tRNS makes transparent come out of the decoder as black, and
// materials may ignore their alpha.
template <class T>
void restore_transparent_colour(const Header& header, Image& image) {
    const bool grey = header.color_type == kGrey;
    if (!grey && header.color_type != kTruecolour) return;
    if (header.transparent.size() != (grey ? 2u : 6u)) return;
    const std::uint64_t most = (1u << header.depth) - 1;
    T color[3];
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint64_t value = big_endian(header.transparent.subspan(grey ? 0 : 2 * c, 2));
        color[c] = T(header.depth < 8 ? (value & most) * 255 / most : value & most);
    }
    T* pixel = reinterpret_cast<T*>(image.pixels.data());
    T* const end = pixel + image.pixels.size() / sizeof(T);
    for (; pixel != end; pixel += 4)
        if (pixel[3] == 0) std::copy(color, color + 3, pixel);
}

// Where rows as the file stores them may begin in the memory that their pixels come to fill. Row
// y's pixels, written once it is read, must end before it begins: the next row's filter reads it
// again. That holds for all rows where it does for the first and the last one.
std::uint64_t stored_begin(std::uint32_t rows, std::int64_t pixel_bytes,
                           std::int64_t stored_bytes) {
    const std::int64_t pixel_row = pixel_bytes / rows, stored_row = stored_bytes / rows;
    return std::uint64_t(std::max(pixel_row, pixel_bytes - (stored_bytes - stored_row)));
}

// Decodes the rows, then reads on to the end of the file to know that it is whole.
wuffs_base__status decode_pixels(wuffs_png__decoder& decoder, wuffs_base__io_buffer& source,
                                 wuffs_base__image_config config, bool interlaced, Image& image) {
    const std::uint64_t stored_bytes = decoder.workbuf_len().min_incl;
    const std::uint64_t pixel_bytes =
        std::uint64_t(image.width) * image.height * bytes_per_pixel(image.format);
    ByteArray apart(interlaced ? stored_bytes : 0);  // interlaced rows are read out of order
    const std::uint64_t begin =
        stored_begin(image.height, std::int64_t(pixel_bytes), std::int64_t(stored_bytes));
    image.pixels.resize(interlaced ? pixel_bytes : begin + stored_bytes);
    const std::span memory = image.pixels;
    const std::span stored = interlaced ? std::span(apart) : memory.subspan(begin);

    const std::uint32_t format = image.format == PixelFormat::rgba16
                                     ? WUFFS_BASE__PIXEL_FORMAT__BGRA_NONPREMUL_4X16LE
                                     : WUFFS_BASE__PIXEL_FORMAT__RGBA_NONPREMUL;
    config.pixcfg.set(format, WUFFS_BASE__PIXEL_SUBSAMPLING__NONE, image.width, image.height);
    wuffs_base__pixel_buffer pixels{};
    wuffs_base__status status =
        pixels.set_from_slice(&config.pixcfg, slice(memory.first(pixel_bytes)));
    if (!status.is_ok()) return status;
    status = decoder.decode_frame(&pixels, &source, WUFFS_BASE__PIXEL_BLEND__SRC, slice(stored),
                                  nullptr);
    image.pixels.resize(pixel_bytes);
    while (status.is_ok())
        status = decoder.decode_frame_config(nullptr, &source);
    if (status.repr == wuffs_base__note__end_of_data) return wuffs_base__make_status(nullptr);
    return status;
}

}  // namespace

Result<Image> decode_png(Bytes bytes, std::string_view name) {
    HM_TRY_ASSIGN(const Header header, read_header(bytes, name));
    // A texture is the still picture of an animation, which need not be its first frame. The
    // decoder gives that where it does not know acTL.
    std::vector<std::byte> still;
    if (header.animation_type != 0) {
        still.assign(bytes.begin(), bytes.end());
        still[header.animation_type] = std::byte('s');
        bytes = still;
    }
    const wuffs_png__decoder::unique_ptr decoder = wuffs_png__decoder::alloc();
    if (!decoder) throw std::bad_alloc();
    wuffs_base__io_buffer source = wuffs_base__slice_u8__reader(read_only(bytes), true);
    wuffs_base__image_config config{};
    wuffs_base__status status = decoder->decode_image_config(&config, &source);
    if (!status.is_ok()) return refuse(name, status);
    const std::uint32_t width = config.pixcfg.width(), height = config.pixcfg.height();
    HM_TRY(check_image_size(width, height, name));

    // Deflate turns one byte into at most 1032 (two bits for a run of 258).
    const std::uint64_t pixels = std::uint64_t(width) * height;
    if (pixels * bits_per_pixel(header) / 8 > bytes.size() * 1032)
        return refuse(name, fmt::format("{} bytes are too few for {} x {} pixels", bytes.size(),
                                        width, height));

    Image image{width, height, header.depth == 16 ? PixelFormat::rgba16 : PixelFormat::rgba8, {}};
    status = decode_pixels(*decoder, source, config, header.interlaced, image);
    if (!status.is_ok()) return refuse(name, status);
    if (image.format == PixelFormat::rgba16) {
        exchange_red_and_blue(image.pixels);
        restore_transparent_colour<std::uint16_t>(header, image);
    } else {
        restore_transparent_colour<std::uint8_t>(header, image);
    }
    return image;
}

}  // namespace hm
