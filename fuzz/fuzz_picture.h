// What the picture targets ask of a decoder's answer. A failed check stops the fuzzer.
#pragma once

#include <cstdint>
#include <span>

#include "base/check.h"
#include "image/image.h"

namespace hm::fuzz {

inline std::span<const std::byte> bytes_of(const std::uint8_t* data, std::size_t size) {
    return std::as_bytes(std::span<const std::uint8_t>(data, size));
}

template <class T>
void check_picture(const ImageOf<T>& image) {
    HM_CHECK(image.width > 0 && image.height > 0, "a picture has pixels");
    HM_CHECK(image.pixels.size() == std::size_t(image.width) * image.height,
             "the size is what the header says");
}

}  // namespace hm::fuzz
