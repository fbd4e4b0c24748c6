// Pictures for textures, and their PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace hm {

// 8-bit pixels, rows from the top; 1, 3 or 4 channels.
struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 3;
    std::vector<std::uint8_t> pixels;
};

// `name` is for error messages.
Result<std::vector<std::byte>> encode_png(const std::string& name, const Picture& picture);

}  // namespace hm
