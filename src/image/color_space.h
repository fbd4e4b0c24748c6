// RGB colour spaces defined by chromaticities, and their conversion to linear Rec. 709.
#pragma once

#include <array>
#include <optional>

#include "image/image.h"

namespace hm {

// CIE 1931 xy of the primaries and the white point.
struct Chromaticities {
    std::array<double, 2> red, green, blue, white;
    bool operator==(const Chromaticities&) const = default;
};

// ITU-R BT.709, white point D65.
inline constexpr Chromaticities kRec709 = {
    {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};

// CIE XYZ with an equal-energy white point, as in Radiance's XYZE format.
inline constexpr Chromaticities kXyz = {{1, 0}, {0, 1}, {0, 0}, {1.0 / 3.0, 1.0 / 3.0}};

// Within 0.001, the precision in which primaries are usually given.
bool is_rec709(const Chromaticities& c);

using Matrix3 = std::array<std::array<double, 3>, 3>;  // rows

// From linear RGB to linear Rec. 709 with Bradford chromatic adaptation (K. Lam, 1985): grey stays
// grey. Colours outside the Rec. 709 gamut get negative components. nullopt if the chromaticities
// are degenerate, e.g. zero or NaN.
std::optional<Matrix3> to_rec709(const Chromaticities& from);

// Converts R, G and B of every pixel.
FloatImage convert(FloatImage image, const Matrix3& matrix);

}  // namespace hm
