#include "image/color_space.h"

#include <cmath>
#include <cstddef>

namespace hm {
namespace {

using Vector3 = std::array<double, 3>;

Vector3 multiply(const Matrix3& m, const Vector3& v) {
    Vector3 result{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t k = 0; k < 3; ++k)
            result[row] += m[row][k] * v[k];
    return result;
}

Matrix3 multiply(const Matrix3& a, const Matrix3& b) {
    Matrix3 result{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            for (std::size_t k = 0; k < 3; ++k)
                result[row][column] += a[row][k] * b[k][column];
    return result;
}

Matrix3 diagonal(const Vector3& v) {
    return {{{v[0], 0, 0}, {0, v[1], 0}, {0, 0, v[2]}}};
}

// By cofactors; nullopt if the determinant is almost zero or not finite.
std::optional<Matrix3> inverse(const Matrix3& m) {
    Matrix3 cofactors{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3;
            const std::size_t c1 = (c + 1) % 3, c2 = (c + 2) % 3;
            cofactors[c][r] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
        }
    double determinant = 0;
    for (std::size_t k = 0; k < 3; ++k)
        determinant += m[0][k] * cofactors[k][0];
    if (!(std::abs(determinant) > 1e-6) || !std::isfinite(determinant)) return std::nullopt;
    for (auto& row : cofactors)
        for (double& value : row)
            value /= determinant;
    return cofactors;
}

// XYZ with x + y + z = 1.
Vector3 xyz_of(const std::array<double, 2>& xy) {
    return {xy[0], xy[1], 1.0 - xy[0] - xy[1]};
}

// XYZ of the white point with Y = 1.
std::optional<Vector3> white_of(const Chromaticities& c) {
    if (!(c.white[1] > 0.0)) return std::nullopt;
    Vector3 white = xyz_of(c.white);
    for (double& value : white)
        value /= c.white[1];
    return white;
}

// The columns are the primaries, scaled to add up to white.
std::optional<Matrix3> rgb_to_xyz(const Chromaticities& c) {
    const Vector3 red = xyz_of(c.red), green = xyz_of(c.green), blue = xyz_of(c.blue);
    Matrix3 primaries{};
    for (std::size_t row = 0; row < 3; ++row)
        primaries[row] = {red[row], green[row], blue[row]};
    const auto inverted = inverse(primaries);
    const auto white = white_of(c);
    if (!inverted || !white) return std::nullopt;
    return multiply(primaries, diagonal(multiply(*inverted, *white)));
}

}  // namespace

bool is_rec709(const Chromaticities& c) {
    const auto near = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
        return std::abs(a[0] - b[0]) <= 1e-3 && std::abs(a[1] - b[1]) <= 1e-3;
    };
    return near(c.red, kRec709.red) && near(c.green, kRec709.green) && near(c.blue, kRec709.blue) &&
           near(c.white, kRec709.white);
}

std::optional<Matrix3> to_rec709(const Chromaticities& from) {
    constexpr Matrix3 kBradford = {
        {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
    const auto source = rgb_to_xyz(from);
    const auto source_white = white_of(from);
    if (!source || !source_white) return std::nullopt;
    const Vector3 cones = multiply(kBradford, *source_white);
    const Vector3 d65 = multiply(kBradford, *white_of(kRec709));
    const Matrix3 scale = diagonal({d65[0] / cones[0], d65[1] / cones[1], d65[2] / cones[2]});
    const Matrix3 adapt = multiply(*inverse(kBradford), multiply(scale, kBradford));
    const Matrix3 result = multiply(*inverse(*rgb_to_xyz(kRec709)), multiply(adapt, *source));
    for (const auto& row : result)
        for (const double value : row)
            if (!std::isfinite(value)) return std::nullopt;
    return result;
}

FloatImage convert(FloatImage image, const Matrix3& matrix) {
    for (Rgba<float>& pixel : image.pixels) {
        const Vector3 converted =
            multiply(matrix, Vector3{double(pixel[0]), double(pixel[1]), double(pixel[2])});
        for (std::size_t c = 0; c < 3; ++c)
            pixel[c] = float(converted[c]);
    }
    return image;
}

}  // namespace hm
