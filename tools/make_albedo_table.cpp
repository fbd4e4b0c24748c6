// Writes src/shading/tables/albedo.inl: the directional albedo of GGX reflection, split by
// Schlick's Fresnel into f0 * x + f90 * y, for 32 roughnesses (rows, even in [0, 1]) times 32
// cosines (columns, even in sqrt(cos)). Integrated in double over visible normals (Dupuy and
// Benyoub 2023) by the midpoint rule.
//
//     make_albedo_table > src/shading/tables/albedo.inl
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

struct Split {
    double x = 0, y = 0;
};

Split integrate(double cos_o, double alpha) {
    constexpr int kSteps = 384;
    const double sin_o = std::sqrt(1 - cos_o * cos_o);
    const double a2 = alpha * alpha;
    const double stretched = std::sqrt(a2 * sin_o * sin_o + cos_o * cos_o);
    const double wx = alpha * sin_o / stretched, wz = cos_o / stretched;
    Split sum;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            // A point of the spherical cap visible from wo, unstretched to a microfacet normal.
            double z = (1 - (i + 0.5) / kSteps) * (1 + wz) - wz;
            double phi = 2 * std::numbers::pi * (j + 0.5) / kSteps;
            double s = std::sqrt(std::max(0.0, 1 - z * z));
            double hx = alpha * (s * std::cos(phi) + wx), hy = alpha * s * std::sin(phi),
                   hz = z + wz;
            double length = std::sqrt(hx * hx + hy * hy + hz * hz);
            double cos_d = (sin_o * hx + cos_o * hz) / length;
            double cos_i = 2 * cos_d * hz / length - cos_o;
            if (cos_i <= 0) continue;
            // G2 / G1 of the height-correlated Smith function.
            double lo = std::sqrt(a2 + (1 - a2) * cos_o * cos_o);
            double li = std::sqrt(a2 + (1 - a2) * cos_i * cos_i);
            double weight = cos_i * (cos_o + lo) / (cos_i * lo + cos_o * li);
            double grazing = std::pow(std::max(0.0, 1 - cos_d), 5);
            sum.x += weight * (1 - grazing);
            sum.y += weight * grazing;
        }
    return {sum.x / (double(kSteps) * kSteps), sum.y / (double(kSteps) * kSteps)};
}

}  // namespace

int main() {
    fmt::print(
        "// GGX albedo split, 32 roughnesses x 32 cosines (x, y). Written by "
        "tools/make_albedo_table.\n");
    for (int row = 0; row < 32; ++row) {
        double roughness = std::max(row / 31.0, 1e-2);
        for (int column = 0; column < 32; ++column) {
            double root = column / 31.0;
            Split e = integrate(std::clamp(root * root, 1e-5, 1.0), roughness * roughness);
            fmt::print("{:.7e}f, {:.7e}f,{}", e.x, e.y, column % 4 == 3 ? "\n" : " ");
        }
    }
    return 0;
}
