#include "shading/tables/tables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>

#include "shading/rng.h"

namespace hm {
namespace {

constexpr std::uint32_t kSobolDirections[] = {
#include "shading/tables/sobol_directions.inl"
};
constexpr std::uint16_t kBlueNoise[] = {
#include "shading/tables/blue_noise_128.inl"
};
constexpr float kAlbedo[] = {
#include "shading/tables/albedo.inl"
};
constexpr float kSheenAlbedo[] = {
#include "shading/tables/sheen_albedo.inl"
};
constexpr float kGlassAlbedo[] = {
#include "shading/tables/glass_albedo.inl"
};
constexpr float kAnisotropicAlbedo[] = {
#include "shading/tables/anisotropic_albedo.inl"
};

// Entry 16 p + d: what digit d at place p of a bit-reversed index adds to the bit-reversed Sobol
// numbers of dimensions 0 to 3.
void fill_sobol_nibbles(ShadingTables& t) {
    for (std::uint32_t place = 0; place < 8; ++place)
        for (std::uint32_t digit = 0; digit < 16; ++digit) {
            uvec4 x(0);
            for (std::uint32_t bit = 0; bit < 4; ++bit) {
                if ((digit >> bit & 1) == 0) continue;
                std::uint32_t index_bit = 31 - (4 * place + bit);
                for (std::size_t d = 0; d < 4; ++d)
                    x[d] ^= reverse_bits(t.sobol_directions[d * 32 + index_bit]);
            }
            t.sobol_nibbles[16 * place + digit] = x;
        }
}

// Copies numbers to floats or to vectors of them.
template <class Table, std::size_t kSize>
void fill(Table& table, const float (&numbers)[kSize]) {
    static_assert(sizeof(Table) == sizeof(numbers));
    std::memcpy(table.data(), numbers, sizeof(numbers));
}

// Means over the hemisphere, 2 * integral of E(mu) mu dmu, of the table as it is interpolated
// (linear in sqrt(mu)), so that compensation normalises by what lookups return.
void fill_albedo_average(ShadingTables& t) {
    constexpr int kSteps = 4096;
    for (std::size_t row = 0; row < kAlbedoRows; ++row) {
        double x = 0, y = 0;
        for (int i = 0; i < kSteps; ++i) {
            double mu = (i + 0.5) / kSteps;
            double column = std::sqrt(mu) * double(kAlbedoColumns - 1);
            std::size_t c = std::min(std::size_t(column), std::size_t(kAlbedoColumns) - 2);
            double f = column - double(c);
            vec2 low = t.albedo_table[row * kAlbedoColumns + c];
            vec2 high = t.albedo_table[row * kAlbedoColumns + c + 1];
            x += 2 * mu * (double(low.x) * (1 - f) + double(high.x) * f) / kSteps;
            y += 2 * mu * (double(low.y) * (1 - f) + double(high.y) * f) / kSteps;
        }
        t.albedo_average[row] = vec2(float(x), float(y));
    }
}

ShadingTables make_tables() {
    ShadingTables t{};
    static_assert(std::size(kSobolDirections) == 128 * 32 && std::size(kBlueNoise) == 128 * 128);
    for (std::size_t i = 0; i < t.sobol_directions.size(); ++i)
        t.sobol_directions[i] = kSobolDirections[i];
    for (std::size_t i = 0; i < t.blue_noise.size(); ++i)
        t.blue_noise[i] = kBlueNoise[i];
    fill(t.albedo_table, kAlbedo);
    fill(t.sheen_albedo, kSheenAlbedo);
    fill(t.glass_albedo, kGlassAlbedo);
    fill(t.anisotropic_albedo, kAnisotropicAlbedo);
    fill_sobol_nibbles(t);
    fill_albedo_average(t);
    return t;
}

double filter_value(PixelFilter filter, double x) {
    constexpr double pi = std::numbers::pi;
    if (filter == PixelFilter::gaussian) return std::exp(-2.0 * x * x);  // sigma is half of half
    if (filter == PixelFilter::blackman_harris) {
        double t = pi * (x + 1.0);
        return 0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) -
               0.01168 * std::cos(3 * t);
    }
    return 1.0;
}

}  // namespace

const ShadingTables& shading_tables() {
    static const ShadingTables tables = make_tables();
    return tables;
}

std::array<float, 257> make_filter_table(PixelFilter filter) {
    constexpr int kSteps = 1 << 14;
    std::array<double, kSteps + 1> cdf{};
    for (std::size_t i = 0; i < kSteps; ++i)
        cdf[i + 1] = cdf[i] + filter_value(filter, (double(i) + 0.5) * 2.0 / kSteps - 1.0);
    std::array<float, 257> table{};
    std::size_t i = 0;
    for (std::size_t k = 0; k < table.size(); ++k) {
        double target = cdf[kSteps] * double(k) / double(table.size() - 1);
        while (i + 1 < kSteps && cdf[i + 1] < target)
            ++i;
        double f = (target - cdf[i]) / (cdf[i + 1] - cdf[i]);
        table[k] = float((double(i) + f) * 2.0 / kSteps - 1.0);
    }
    return table;
}

}  // namespace hm
