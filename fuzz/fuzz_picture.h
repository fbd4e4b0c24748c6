// What the picture targets ask of a decoder's answer. A failed check stops the fuzzer.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

#include "base/check.h"
#include "base/result.h"
#include "image/image.h"

namespace hm::fuzz {

inline std::span<const std::byte> bytes_of(const std::uint8_t* data, std::size_t size) {
    return std::as_bytes(std::span<const std::uint8_t>(data, size));
}

// A picture has as many bytes as its size says, and its floats are fit for lighting.
inline void check_picture(const Result<Image>& image) {
    if (!image) {
        HM_CHECK(!image.error().message.empty(), "an error says why");
        return;
    }
    HM_CHECK(image->width > 0 && image->height > 0, "a picture has pixels");
    HM_CHECK(image->pixels.size() ==
                 std::size_t(image->width) * image->height * bytes_per_pixel(image->format),
             "the size is what the header says");
    if (image->format != PixelFormat::rgba32f) return;
    for (std::size_t i = 0; i < image->pixels.size(); i += sizeof(float)) {
        float value = 0;
        std::memcpy(&value, &image->pixels[i], sizeof value);
        HM_CHECK(std::isfinite(value) && value >= 0, "a radiance is finite and not negative");
    }
}

}  // namespace hm::fuzz
