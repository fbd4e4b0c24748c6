// Error maps: the difference of two pictures per pixel.
#pragma once

#include "image/image.h"
#include "image/plane.h"

namespace hm {

// Per pixel, over R, G and B of two pictures of the same size: the root mean square error, and the
// mean of (a - b)² / (b² + 0.01). `b` is the reference.
Plane absolute_error(const FloatImage& a, const FloatImage& b);
Plane relative_squared_error(const FloatImage& a, const FloatImage& b);

// Maps [0, 1] to matplotlib's "magma" colours in sRGB, from black through violet and orange to
// light yellow. Values outside are clamped; NaN becomes pure green, which magma does not contain.
Image8 magma(const Plane& plane);

// The values as grey.
FloatImage grey(const Plane& plane);

}  // namespace hm
