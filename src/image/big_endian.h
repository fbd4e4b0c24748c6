// Numbers as PNG and JPEG store them.
#pragma once

#include <cstdint>

#include "image/codecs.h"

namespace hm {

// All of `bytes`, at most eight, as one number; the first is the most significant.
inline std::uint64_t big_endian(Bytes bytes) {
    std::uint64_t value = 0;
    for (const std::byte b : bytes)
        value = value << 8 | std::to_integer<std::uint64_t>(b);
    return value;
}

}  // namespace hm
