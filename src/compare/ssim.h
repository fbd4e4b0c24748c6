// Structural similarity: Wang, Bovik, Sheikh and Simoncelli, "Image Quality Assessment: From Error
// Visibility to Structural Similarity" (2004).
#pragma once

#include <optional>

#include "image/plane.h"

namespace hm {

// Mean over all windows of 11 x 11 pixels, weighted by a Gaussian of sigma 1.5, with K1 = 0.01 and
// K2 = 0.03. The planes have values in [0, 1]. 1 if they are equal; nullopt if they are smaller
// than a window.
std::optional<double> ssim(const Plane& a, const Plane& b);

}  // namespace hm
