// What a picture will take in memory, from its header alone.
#pragma once

#include <cstdint>
#include <optional>

#include "image/codecs.h"

namespace hm {

// Bytes of the pixels that read_texture_image would return; nothing where the header is damaged or
// the format is no texture's, which read_texture_image then says.
std::optional<std::uint64_t> decoded_size(Bytes bytes);

}  // namespace hm
