// Whether two noisy pictures can be of the same scene: a z-test over blocks of pixels and over the
// whole, from the variance that each picture carries.
#pragma once

#include <array>
#include <cstddef>

#include "image/image.h"

namespace hm {

// How often two pictures of the same scene are to be told apart by mistake.
inline constexpr double kZTestLevel = 1e-4;

struct ZTest {
    std::size_t comparisons = 0;    // each channel of each block, and of the whole
    double threshold = 0;           // what |z| exceeds with probability kZTestLevel / comparisons
    double largest = 0;             // |z| over all comparisons; infinite where nothing varies
    std::size_t beyond = 0;         // comparisons above the threshold
    std::array<double, 3> whole{};  // z of the whole picture's mean, by channel
    bool agree() const { return beyond == 0; }
};

// All rgba32f of one size. A variance is that of the pixel's mean, not of a sample. Blocks of 8 x 8
// pixels, so that the variances' own noise averages out even where four replicates gave them.
// Pixels with values that are not finite do not count.
ZTest z_test(const FloatImage& a, const FloatImage& variance_a, const FloatImage& b,
             const FloatImage& variance_b);

}  // namespace hm
