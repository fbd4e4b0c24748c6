// PNG (second edition, 11.2.2: IHDR comes first) and JPEG (ITU T.81, B.2.2: the frame header).
#include "image/decoded_size.h"

#include "image/big_endian.h"
#include "image/read.h"

namespace hm {
namespace {

std::optional<std::uint64_t> png_size(Bytes bytes) {
    constexpr std::size_t kWidth = 16, kHeight = 20, kDepth = 24;
    if (bytes.size() <= kDepth) return std::nullopt;
    const std::uint64_t width = big_endian(bytes.subspan(kWidth, 4));
    const std::uint64_t height = big_endian(bytes.subspan(kHeight, 4));
    if (width > kMaxImageSide || height > kMaxImageSide) return std::nullopt;
    return width * height *
           bytes_per_pixel(bytes[kDepth] == std::byte(16) ? PixelFormat::rgba16
                                                          : PixelFormat::rgba8);
}

// Start of frame: 0xC0 to 0xCF except DHT, JPG and DAC.
bool is_frame(std::uint64_t marker) {
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

std::optional<std::uint64_t> jpeg_size(Bytes bytes) {
    std::size_t at = 2;
    while (at + 4 <= bytes.size()) {
        const std::uint64_t marker = big_endian(bytes.subspan(at + 1, 1));
        // Skip stray bytes and fill bytes before a marker, like the decoder.
        if (bytes[at] != std::byte(0xFF) || marker == 0xFF || marker == 0) {
            ++at;
            continue;
        }
        if (is_frame(marker)) {
            if (at + 9 > bytes.size()) return std::nullopt;
            return big_endian(bytes.subspan(at + 5, 2)) * big_endian(bytes.subspan(at + 7, 2)) *
                   bytes_per_pixel(PixelFormat::rgba8);
        }
        const bool has_no_length = marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8);
        at += 2 + (has_no_length ? 0 : big_endian(bytes.subspan(at + 2, 2)));
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> decoded_size(Bytes bytes) {
    switch (file_format(bytes)) {
        case FileFormat::png:
            return png_size(bytes);
        case FileFormat::jpeg:
            return jpeg_size(bytes);
        default:
            return std::nullopt;
    }
}

}  // namespace hm
