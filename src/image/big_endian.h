// Big-endian integers, as in PNG and JPEG.
#pragma once

#include <cstdint>

#include "image/codecs.h"

namespace hm {

// Interprets all of `bytes`, at most 8, as one big-endian integer.
inline std::uint64_t big_endian(Bytes bytes) {
    std::uint64_t value = 0;
    for (const std::byte b : bytes)
        value = value << 8 | std::to_integer<std::uint64_t>(b);
    return value;
}

}  // namespace hm
