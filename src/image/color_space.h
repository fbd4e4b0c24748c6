// RGB colour spaces by their chromaticities, and what leads from them to linear Rec. 709.
#pragma once

#include <array>
#include <optional>

#include "image/image.h"

namespace hm {

// CIE 1931 x and y of the primaries and of white.
struct Chromaticities {
    std::array<double, 2> red, green, blue, white;
    bool operator==(const Chromaticities&) const = default;
};

// ITU-R BT.709, white D65.
inline constexpr Chromaticities kRec709 = {
    {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};

// CIE XYZ with an equal-energy white, which is what Radiance means by XYZ.
inline constexpr Chromaticities kXyz = {{1, 0}, {0, 1}, {0, 0}, {1.0 / 3.0, 1.0 / 3.0}};

// To a thousandth, which is how primaries are quoted.
bool is_rec709(const Chromaticities& c);

using Matrix3 = std::array<std::array<double, 3>, 3>;  // rows

// From linear RGB to linear Rec. 709, with white adapted by Bradford's cone responses (K. Lam,
// 1985): grey stays grey. Colours outside of Rec. 709 get negative components. Nothing where the
// chromaticities span no plane, as zeros and NaN.
std::optional<Matrix3> to_rec709(const Chromaticities& from);

// R, G and B of every pixel.
FloatImage convert(FloatImage image, const Matrix3& matrix);

}  // namespace hm
