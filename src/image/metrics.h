// How far one picture is from another.
#pragma once

#include "image/image.h"

namespace hm {

struct ImageError {
    double mse = 0.0;
    double rmse = 0.0;
    double relative_mse = 0.0;  // mean of (a - b)^2 / (b^2 + 0.01)
    double max_abs = 0.0;
};

// Over R, G and B of two rgba32f pictures of the same size; `b` is the reference. A NaN in either
// makes every number NaN.
ImageError compare_images(const Image& a, const Image& b);

}  // namespace hm
