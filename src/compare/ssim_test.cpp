#include "compare/ssim.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hm {
namespace {

Plane constant(float value) {
    Plane plane(16, 13);
    for (float& v : plane.values)
        v = value;
    return plane;
}

TEST(Ssim, ClosedForms) {
    Plane stripes = constant(0);
    for (std::size_t i = 0; i < stripes.values.size(); ++i)
        stripes.values[i] = 0.5f + 0.25f * float(std::sin(double(i % 16) + 0.3 * double(i / 16)));
    EXPECT_NEAR(*ssim(stripes, stripes), 1.0, 1e-12);
    // Constants have no variance, so only the luminance term is left.
    EXPECT_NEAR(*ssim(constant(0.5f), constant(0.25f)),
                (2 * 0.5 * 0.25 + 1e-4) / (0.25 + 0.0625 + 1e-4), 1e-5);
    // With values mirrored about the mean, the covariance is minus the variance.
    Plane negative = stripes;
    for (float& v : negative.values)
        v = 1.0f - v;
    EXPECT_LT(*ssim(stripes, negative), -0.8);
}

// Against a direct evaluation of the definition.
TEST(Ssim, MatchesTheDefinition) {
    Plane a(12, 11), b(12, 11);
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        a.values[i] = float(i * 7919 % 101) / 100.0f;
        b.values[i] = float(i * 104729 % 97) / 96.0f;
    }
    double expected = 0;
    for (std::size_t left = 0; left < 2; ++left) {
        double sum = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
        for (std::size_t y = 0; y < 11; ++y)
            for (std::size_t x = 0; x < 11; ++x) {
                const double dx = double(x) - 5, dy = double(y) - 5;
                const double w = std::exp(-(dx * dx + dy * dy) / (2 * 1.5 * 1.5));
                const double va = double(a.values[y * 12 + x + left]);
                const double vb = double(b.values[y * 12 + x + left]);
                sum += w, ma += w * va, mb += w * vb;
                aa += w * va * va, bb += w * vb * vb, ab += w * va * vb;
            }
        ma /= sum, mb /= sum;
        const double va = aa / sum - ma * ma, vb = bb / sum - mb * mb, cov = ab / sum - ma * mb;
        expected += 0.5 * (2 * ma * mb + 1e-4) * (2 * cov + 9e-4) /
                    ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4));
    }
    EXPECT_NEAR(*ssim(a, b), expected, 1e-5);
}

TEST(Ssim, SmallPicturesHaveNone) {
    EXPECT_FALSE(ssim(Plane(10, 50), Plane(10, 50)));
    EXPECT_FALSE(ssim(Plane(50, 10), Plane(50, 10)));
    EXPECT_TRUE(ssim(Plane(11, 11), Plane(11, 11)));
}

}  // namespace
}  // namespace hm
