// Tests the hypothesis that two noisy pictures have the same expected value: a z-test over blocks
// of pixels and over the whole picture, using the variance layer of each picture.
#pragma once

#include <array>
#include <cstddef>

#include "image/image.h"

namespace hm {

// Significance level: the probability of a false positive.
inline constexpr double kZTestLevel = 1e-4;

struct ZTest {
    std::size_t comparisons = 0;  // each channel of each block and of the whole picture
    double threshold = 0;         // exceeded by |z| with probability kZTestLevel / comparisons
    double largest = 0;      // |z| of all comparisons; infinite for a difference without variance
    std::size_t beyond = 0;  // comparisons above the threshold
    std::array<double, 3> whole{};  // z of the whole picture's mean, by channel
    bool agree() const { return beyond == 0; }
};

// All pictures have the same size. The variances are those of the pixels' means, not of samples.
// Blocks have 8 x 8 pixels, which averages out the noise of variances that were estimated from only
// four replicates. Pixels with NaN or infinity are excluded.
ZTest z_test(const FloatImage& a, const FloatImage& variance_a, const FloatImage& b,
             const FloatImage& variance_b);

}  // namespace hm
