// Values of environments: finite, not negative, linear Rec. 709.
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

// The largest value of a 16-bit float replaces an infinite radiance, which mostly is the overflow
// of one.
inline constexpr float kInfiniteRadiance = 65504.0f;

// Finite and not negative.
inline float clean_radiance(float value) {
    if (!(value > 0.0f)) return 0.0f;  // NaN as well
    return value > 3.4028234e38f ? kInfiniteRadiance : value;
}

// Turns stored pixels into radiance and counts what it replaces.
class RadianceReader {
  public:
    // Stored values are linear RGB of these primaries.
    explicit RadianceReader(const std::optional<Matrix3>& to_rec709) : matrix_(to_rec709) {}

    // With alpha 1.
    Rgba<float> convert(float r, float g, float b);
    // One warning for all that was replaced, if anything was.
    void report(const char* format, ReadWarnings& warnings) const;

  private:
    float clean(float value);

    std::optional<Matrix3> matrix_;  // nothing: the values are Rec. 709 already
    std::size_t infinite_ = 0, nan_ = 0, negative_ = 0, outside_ = 0;
};

}  // namespace hm
