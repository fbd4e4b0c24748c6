// Texels of an image in memory, decoded to linear floats. Plain data and inline code: the
// renderer's inner loop reads textures through this.
#pragma once

#include <cstdint>

#include "shading/lang.h"

namespace hm {

struct ImageView {
    const void* pixels;
    std::uint32_t width;
    std::uint32_t height;
    std::uint32_t format;  // PixelFormat, 8 or 16 bits per channel
};

// srgb_to_linear of i / 255, for the caller to pass to fetch_image_texel.
const float* srgb_table();

inline vec4 fetch_image_texel(const ImageView& image, std::uint32_t x, std::uint32_t y, bool srgb,
                              const float* table) {
    std::size_t index = (std::size_t(y) * image.width + x) * 4;
    if (image.format == 0) {
        const std::uint8_t* t = static_cast<const std::uint8_t*>(image.pixels) + index;
        // Via 16 bits: c * 257 repeats the byte, so both formats give the same float.
        const auto unit = [](std::uint8_t c) { return float(c * 257) * (1.0f / 65535.0f); };
        if (srgb) return vec4(table[t[0]], table[t[1]], table[t[2]], unit(t[3]));
        return vec4(unit(t[0]), unit(t[1]), unit(t[2]), unit(t[3]));
    }
    // 16-bit sRGB colour: linear interpolation between the two nearest 8-bit table entries is
    // accurate to 2e-5.
    const std::uint16_t* t = static_cast<const std::uint16_t*>(image.pixels) + index;
    vec4 c;
    for (int k = 0; k < 4; ++k) {
        float v = float(t[k]) * (1.0f / 65535.0f);
        if (srgb && k < 3) {
            std::uint32_t low = t[k] / 257u;
            std::uint32_t high = low < 255u ? low + 1u : 255u;
            float f = v * 255.0f - float(low);
            v = table[low] + (table[high] - table[low]) * f;
        }
        c[std::size_t(k)] = v;
    }
    return c;
}

}  // namespace hm
