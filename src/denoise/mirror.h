// Padding of small pictures: the denoiser treats everything beyond the edges as black, which
// darkens pictures of a few pixels.
#pragma once

#include "image/image.h"

namespace hm {

// The picture in the centre of one with at least `side` pixels in each dimension, padded by
// mirroring.
FloatImage mirrored(const FloatImage& image, std::uint32_t side);

// The inverse of `mirrored`: crops to the original picture.
FloatImage middle(const FloatImage& image, std::uint32_t width, std::uint32_t height);

}  // namespace hm
