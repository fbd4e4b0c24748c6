// Small pictures made larger: a filter over a neighbourhood takes what lies beyond the edges for
// black, which darkens pictures of a few pixels.
#pragma once

#include "image/image.h"

namespace hm {

// The picture in the middle of one of at least `side` pixels each way, continued by its mirror
// images.
FloatImage mirrored(const FloatImage& image, std::uint32_t side);

// The part of a picture that `mirrored` made that is the picture itself.
FloatImage middle(const FloatImage& image, std::uint32_t width, std::uint32_t height);

}  // namespace hm
