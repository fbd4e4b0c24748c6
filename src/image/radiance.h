// Environment radiance: finite, non-negative, linear Rec. 709.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "image/color_space.h"
#include "image/image.h"
#include "image/read.h"

namespace hm {

// Replaces infinite radiance: the largest 16-bit float, since infinity usually comes from half
// overflow.
inline constexpr float kInfiniteRadiance = 65504.0f;

// Makes a value finite and non-negative.
inline float clean_radiance(float value) {
    if (!(value > 0.0f)) return 0.0f;  // also NaN
    return value > 3.4028234e38f ? kInfiniteRadiance : value;
}

// Converts stored pixels to radiance and counts replaced values.
class RadianceReader {
  public:
    // `to_rec709` converts stored values; unset if they are Rec. 709.
    explicit RadianceReader(const std::optional<Matrix3>& to_rec709) : matrix_(to_rec709) {}

    // The result has alpha 1.
    Rgba<float> convert(float r, float g, float b);
    // Adds warnings with the numbers of replaced values.
    void report(const char* format, ReadWarnings& warnings) const;

  private:
    float clean(float value);

    std::optional<Matrix3> matrix_;
    std::size_t infinite_ = 0, nan_ = 0, negative_ = 0, outside_ = 0;
};

}  // namespace hm
