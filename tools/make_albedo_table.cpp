// Writes src/shading/tables/albedo.inl: the directional albedo of GGX reflection, split by
// Schlick's Fresnel into f0 * x + f90 * y, on kAlbedoRows roughnesses (even in [0, 1]) times
// kAlbedoColumns cosines (even in sqrt(cos)). Integrated in double over visible normals (Dupuy and
// Benyoub 2023).
//
// The entries are not the albedo at the nodes: they are the least-squares fit, weighted by the
// cosine, of what lookups interpolate (shading/material/albedo.h). Constants are among the
// interpolated functions, so a fitted row has exactly the hemispherical mean of the albedo, and the
// error in between rows, which energy compensation turns into a gain or loss of a closed white
// room, is half of that of the values at the nodes.
//
//     make_albedo_table > src/shading/tables/albedo.inl
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "shading/structs.h"

namespace {

constexpr std::size_t kRows = hm::kAlbedoRows, kColumns = hm::kAlbedoColumns;
constexpr std::size_t kFine = 256;        // samples along either axis that the fit is made to
constexpr double kLeastRoughness = 0.04;  // of materials, kMinRoughness

// What energy compensation reads: the mirror's loss, 1 - x - y, and y.
struct Split {
    double loss = 0, grazing = 0;
};

// Even steps in the polar angle of the visible cap and in half of the azimuths.
Split integrate(double cos_o, double alpha) {
    constexpr int kSteps = 256;
    const double sin_o = std::sqrt(1 - cos_o * cos_o);
    const double a2 = alpha * alpha;
    const double stretched = std::sqrt(a2 * sin_o * sin_o + cos_o * cos_o);
    const double wx = alpha * sin_o / stretched, wz = cos_o / stretched;
    const double lo = std::sqrt(a2 + (1 - a2) * cos_o * cos_o);
    const double widest = std::acos(-wz);
    double total = 0, reflected = 0, grazing = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double theta = widest * (i + 0.5) / kSteps;
        const double z = std::cos(theta), s = std::sin(theta);
        for (int j = 0; j < kSteps; ++j) {
            // A point of the spherical cap visible from wo, unstretched to a microfacet normal.
            const double phi = std::numbers::pi * (j + 0.5) / kSteps;
            const double hx = alpha * (s * std::cos(phi) + wx), hy = alpha * s * std::sin(phi),
                         hz = z + wz;
            const double length = std::sqrt(hx * hx + hy * hy + hz * hz);
            const double cos_d = (sin_o * hx + cos_o * hz) / length;
            const double cos_i = 2 * cos_d * hz / length - cos_o;
            total += s;
            if (cos_i <= 0) continue;
            // G2 / G1 of the height-correlated Smith function.
            const double li = std::sqrt(a2 + (1 - a2) * cos_i * cos_i);
            const double weight = s * cos_i * (cos_o + lo) / (cos_i * lo + cos_o * li);
            const double c = std::max(0.0, 1 - cos_d);
            reflected += weight;
            grazing += weight * c * c * c * c * c;
        }
    }
    return {1 - reflected / total, grazing / total};
}

// The values at `size` even nodes of [0, 1] whose linear interpolation fits `samples` at `places`
// best, given their weights: the normal equations are tridiagonal.
std::vector<double> fit(std::size_t size, const std::vector<double>& places,
                        const std::vector<double>& weights, const std::vector<double>& samples) {
    std::vector<double> diagonal(size), above(size), right(size);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double node = places[k] * double(size - 1);
        const std::size_t i = std::min(std::size_t(node), size - 2);
        const double f = node - double(i);
        diagonal[i] += weights[k] * (1 - f) * (1 - f);
        diagonal[i + 1] += weights[k] * f * f;
        above[i] += weights[k] * f * (1 - f);
        right[i] += weights[k] * (1 - f) * samples[k];
        right[i + 1] += weights[k] * f * samples[k];
    }
    for (std::size_t i = 1; i < size; ++i) {
        const double factor = above[i - 1] / diagonal[i - 1];
        diagonal[i] -= factor * above[i - 1];
        right[i] -= factor * right[i - 1];
    }
    for (std::size_t i = size; i-- > 0;)
        right[i] = (right[i] - (i + 1 < size ? above[i] * right[i + 1] : 0)) / diagonal[i];
    return right;
}

struct Axis {
    std::vector<double> places, weights;
};

// Roughnesses that no material has only keep the first rows from being undetermined.
Axis roughness_axis() {
    Axis axis;
    for (std::size_t k = 0; k < kFine; ++k) {
        axis.places.push_back((double(k) + 0.5) / kFine);
        axis.weights.push_back(axis.places.back() < kLeastRoughness ? 0.02 : 1);
    }
    return axis;
}

// cos dcos, over the square root of the cosine.
Axis cosine_axis() {
    Axis axis;
    for (std::size_t k = 0; k < kFine; ++k) {
        const double root = (double(k) + 0.5) / kFine;
        axis.places.push_back(root);
        axis.weights.push_back(root * root * root);
    }
    return axis;
}

using Table = std::vector<std::vector<double>>;  // rows of columns

// Fits columns to each roughness's samples, then rows to each column's values.
Table fit_table(const Table& samples) {
    const Axis roughnesses = roughness_axis(), cosines = cosine_axis();
    Table columns;
    for (const std::vector<double>& row : samples)
        columns.push_back(fit(kColumns, cosines.places, cosines.weights, row));
    Table table(kRows, std::vector<double>(kColumns));
    for (std::size_t c = 0; c < kColumns; ++c) {
        std::vector<double> values;
        for (const std::vector<double>& row : columns)
            values.push_back(row[c]);
        const std::vector<double> fitted =
            fit(kRows, roughnesses.places, roughnesses.weights, values);
        for (std::size_t r = 0; r < kRows; ++r)
            table[r][c] = std::clamp(fitted[r], 0.0, 1.0);  // the fit may swing past either
    }
    return table;
}

}  // namespace

int main() {
    Table loss, grazing;
    for (const double roughness : roughness_axis().places) {
        loss.emplace_back();
        grazing.emplace_back();
        for (const double root : cosine_axis().places) {
            const Split e = integrate(root * root, roughness * roughness);
            loss.back().push_back(e.loss);
            grazing.back().push_back(e.grazing);
        }
    }
    loss = fit_table(loss);
    grazing = fit_table(grazing);
    fmt::print(
        "// GGX albedo split, {} roughnesses x {} cosines (x, y). Written by "
        "tools/make_albedo_table.\n",
        kRows, kColumns);
    for (std::size_t r = 0; r < kRows; ++r)
        for (std::size_t c = 0; c < kColumns; ++c) {
            const double y = std::min(grazing[r][c], 1 - loss[r][c]);
            fmt::print("{:.7e}f, {:.7e}f,{}", 1 - loss[r][c] - y, y, c % 4 == 3 ? "\n" : " ");
        }
    return 0;
}
