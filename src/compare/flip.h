// FLIP: how different two pictures look to someone who flips between them. Andersson et al., "FLIP:
// A Difference Evaluator for Alternating Images" (2020), and for radiance "Visualizing Errors in
// Rendered High Dynamic Range Images" (2021).
#pragma once

#include <cstdint>

#include "image/image.h"
#include "image/plane.h"

namespace hm {

// Pixels per degree of the viewer's visual field: 0.7 m before a display that is 0.7 m and 3840
// pixels wide, as in the papers.
inline constexpr double kFlipPixelsPerDegree = 67.0206432766;

struct HdrFlip {
    Plane error;
    // The exposures, in EV, at which the pictures were looked at; both ends are among them.
    double start_exposure = 0, stop_exposure = 0;
    std::uint32_t exposures = 0;
};

// Both take rgba32f of one size with finite, linear Rec.709 values; alpha does not count. Errors
// lie in [0, 1].

// What displays show: values outside [0, 1] are clamped.
Plane ldr_flip(const FloatImage& reference, const FloatImage& test,
               double pixels_per_degree = kFlipPixelsPerDegree);
// Radiance: the largest LDR-FLIP over a range of exposures that the reference alone decides.
HdrFlip hdr_flip(const FloatImage& reference, const FloatImage& test,
                 double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace hm
