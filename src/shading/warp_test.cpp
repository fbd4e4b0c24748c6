// The warps against their densities, by chi-squared over bins of equal or integrated mass.
#include "shading/warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shading/tables/tables.h"
#include "support/statistics.h"

namespace hm {
namespace {

constexpr int kSamples = 400000;

std::size_t sector(float y, float x, int sectors) {
    double turn = std::atan2(double(y), double(x)) / (2 * std::numbers::pi);
    return std::size_t(std::min(int((turn - std::floor(turn)) * sectors), sectors - 1));
}

TEST(Warp, DiskIsUniform) {
    test::Random random(31);
    test::Histogram histogram(32 * 32);
    for (int i = 0; i < kSamples; ++i) {
        float u = random.unit(), v = random.unit();
        vec2 p = sample_disk(u, v);
        float r2 = dot(p, p);
        ASSERT_LE(r2, 1.0f + 1e-6f);
        int ring = std::min(int(r2 * 32), 31);  // rings of equal area
        histogram.add(std::size_t(ring) * 32 + sector(p.y, p.x, 32));
    }
    EXPECT_GT(histogram.test(std::vector(32 * 32, 1.0 / 1024)).p_value, test::single_level());
}

TEST(Warp, CosineHemisphereMatchesItsDensity) {
    test::Random random(32);
    test::Histogram histogram(32 * 32);
    for (int i = 0; i < kSamples; ++i) {
        float u = random.unit(), v = random.unit();
        vec3 w = sample_cosine_hemisphere(u, v);
        ASSERT_NEAR(length(w), 1.0f, 1e-6f);
        int ring = std::clamp(int(w.z * 32), 0, 31);
        histogram.add(std::size_t(ring) * 32 + sector(w.y, w.x, 32));
    }
    std::vector<double> shares(32 * 32);
    double total = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        for (int k = 0; k < 8; ++k) {
            double z = (double(i / 32) + (k + 0.5) / 8) / 32;
            shares[i] +=
                double(pdf_cosine_hemisphere(float(z))) * 2 * std::numbers::pi / (32.0 * 32 * 8);
        }
        total += shares[i];
    }
    EXPECT_NEAR(total, 1, 1e-6);
    EXPECT_EQ(pdf_cosine_hemisphere(-0.5f), 0.0f);
    EXPECT_GT(histogram.test(shares).p_value, test::single_level());
}

TEST(Warp, TriangleIsUniform) {
    test::Random random(33);
    constexpr int kSide = 24;
    test::Histogram histogram(kSide * kSide);
    for (int i = 0; i < kSamples; ++i) {
        float u = random.unit(), v = random.unit();
        vec2 b = sample_triangle(u, v);
        ASSERT_TRUE(b.x >= 0 && b.y >= 0 && b.x + b.y <= 1.0f + 1e-6f);
        // Back to a square of equal area: a = 1 - b.x is distributed as 1 - a^2.
        float a = 1 - b.x;
        int row = std::min(int(a * a * kSide), kSide - 1);
        int column = std::min(int(b.y / std::max(a, 1e-9f) * kSide), kSide - 1);
        histogram.add(std::size_t(row * kSide + column));
    }
    EXPECT_GT(histogram.test(std::vector(kSide * kSide, 1.0 / (kSide * kSide))).p_value,
              test::single_level());
}

double filter_value(PixelFilter filter, double x) {
    double t = std::numbers::pi * x;
    switch (filter) {
        case PixelFilter::box:
            return 1;
        case PixelFilter::gaussian:
            return std::exp(-0.5 * (x / 0.5) * (x / 0.5));
        case PixelFilter::blackman_harris:  // centred: the odd cosines turn their sign
            return 0.35875 + 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) +
                   0.01168 * std::cos(3 * t);
    }
    return 0;
}

// The integral of the filter from -1 to x, by Simpson's rule.
double filter_integral(PixelFilter filter, double x) {
    constexpr int kSteps = 512;
    double h = (x + 1) / kSteps, sum = 0;
    for (int i = 0; i <= kSteps; ++i)
        sum += filter_value(filter, -1 + h * i) * (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2);
    return sum * h / 3;
}

TEST(Warp, FilterTablesInvertTheirFilters) {
    for (PixelFilter filter :
         {PixelFilter::box, PixelFilter::gaussian, PixelFilter::blackman_harris}) {
        const std::array<float, 257> table = make_filter_table(filter);
        const double total = filter_integral(filter, 1);
        EXPECT_EQ(table.front(), -1.0f);
        EXPECT_EQ(table.back(), 1.0f);
        for (std::size_t k = 0; k < table.size(); ++k) {
            double share = filter_integral(filter, double(table[k])) / total;
            EXPECT_NEAR(share, double(k) / 256, 2e-6) << int(filter) << " " << k;
            EXPECT_NEAR(table[k], -table[256 - k], 2e-5f);
        }
    }
}

TEST(Warp, GaussianSigmaIsAFourthOfTheWidth) {
    // Second moment of a Gaussian of sigma 1/2 cut at +-2 sigma: sigma^2 (1 - 4 phi(2) / (2 Phi(2)
    // - 1)), phi and Phi the normal density and distribution.
    const std::array<float, 257> table = make_filter_table(PixelFilter::gaussian);
    double second = 0;
    for (std::size_t k = 0; k < 256; ++k) {
        double a = double(table[k]), b = double(table[k + 1]);
        second += (a * a + a * b + b * b) / 3 / 256;
    }
    double phi = std::exp(-2.0) / std::sqrt(2 * std::numbers::pi);
    EXPECT_NEAR(second, 0.25 * (1 - 4 * phi / std::erf(std::sqrt(2.0))), 2e-4);
}

}  // namespace
}  // namespace hm
