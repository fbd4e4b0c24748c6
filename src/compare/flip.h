// FLIP: the difference that a viewer sees when flipping between two pictures. Andersson et al.,
// "FLIP: A Difference Evaluator for Alternating Images" (2020), and for radiance "Visualizing
// Errors in Rendered High Dynamic Range Images" (2021).
#pragma once

#include <cstdint>

#include "image/image.h"
#include "image/plane.h"

namespace hm {

// Pixels per degree of visual angle, as in the papers: a display 0.7 m and 3840 pixels wide, viewed
// from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67.0206432766;

struct HdrFlip {
    Plane error;
    // The range of exposures that were compared, in EV, including both ends.
    double start_exposure = 0, stop_exposure = 0;
    std::uint32_t exposures = 0;
};

// Both functions take pictures of the same size with finite, linear Rec.709 values and ignore
// alpha. Errors are in [0, 1].

// LDR-FLIP, for display values: values outside [0, 1] are clamped.
Plane ldr_flip(const FloatImage& reference, const FloatImage& test,
               double pixels_per_degree = kFlipPixelsPerDegree);
// HDR-FLIP, for radiance: the largest LDR-FLIP over a range of exposures, which depends on the
// reference only.
HdrFlip hdr_flip(const FloatImage& reference, const FloatImage& test,
                 double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace hm
