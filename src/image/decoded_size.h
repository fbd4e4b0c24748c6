// Memory size of a decoded picture, from its header alone.
#pragma once

#include <cstdint>
#include <optional>

#include "image/codecs.h"

namespace hm {

// Bytes of the pixels that read_texture_image would return; nullopt if the header is damaged or the
// format is not a texture format, for which read_texture_image reports an error.
std::optional<std::uint64_t> decoded_size(Bytes bytes);

}  // namespace hm
