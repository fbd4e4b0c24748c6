// A picture in memory: four channels, rows from the top, no padding between rows.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/memory.h"

namespace hm {

enum class PixelFormat : std::uint32_t {
    rgba8 = 0,   // four uint8, 0..255 meaning 0..1
    rgba16 = 1,  // four uint16 in the machine's byte order, 0..65535 meaning 0..1
    rgba32f = 2  // four float, linear
};

constexpr std::size_t bytes_per_pixel(PixelFormat format) {
    return format == PixelFormat::rgba8 ? 4 : format == PixelFormat::rgba16 ? 8 : 16;
}

struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    PixelFormat format = PixelFormat::rgba8;
    ByteArray pixels;  // width * height * bytes_per_pixel(format)
};

}  // namespace hm
