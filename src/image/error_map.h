// Pictures of where two pictures differ.
#pragma once

#include "image/image.h"
#include "image/plane.h"

namespace hm {

// Per pixel, over R, G and B of two rgba32f pictures of one size: the root of the mean square, and
// the mean of (a - b)² / (b² + 0.01), `b` being the reference.
Plane absolute_error(const Image& a, const Image& b);
Plane relative_squared_error(const Image& a, const Image& b);

// [0, 1] from black over violet and orange to a light yellow, matplotlib's "magma"; rgba8 in sRGB.
// What is beyond is clamped; NaN is pure green, which magma has nowhere.
Image magma(const Plane& plane);

// The numbers themselves as grey, rgba32f.
Image grey(const Plane& plane);

}  // namespace hm
