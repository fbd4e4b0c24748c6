// Error maps: where two pictures differ.
#pragma once

#include "image/image.h"
#include "image/plane.h"

namespace hm {

// Per pixel, over R, G and B of two pictures of one size: the root of the mean square, and
// the mean of (a - b)² / (b² + 0.01), `b` being the reference.
Plane absolute_error(const FloatImage& a, const FloatImage& b);
Plane relative_squared_error(const FloatImage& a, const FloatImage& b);

// [0, 1] from black over violet and orange to a light yellow, matplotlib's "magma", in sRGB. Values
// outside are clamped; NaN is pure green, which magma does not contain.
Image8 magma(const Plane& plane);

// The values as grey.
FloatImage grey(const Plane& plane);

}  // namespace hm
