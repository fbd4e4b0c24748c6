#include "compare/z_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

constexpr std::uint32_t kWidth = 40, kHeight = 24;

FloatImage constant(float value) {
    FloatImage image(kWidth, kHeight);
    for (std::size_t i = 0; i < kWidth * kHeight; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.pixels[i][c] = value;
    return image;
}

FloatImage noisy(float mean, float sigma, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> noise(mean, sigma);
    FloatImage image = constant(0);
    for (std::size_t i = 0; i < kWidth * kHeight; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.pixels[i][c] = noise(random);
    return image;
}

TEST(ZTest, NoiseOfTheGivenVarianceAgrees) {
    const FloatImage variance = constant(0.01f);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const ZTest test =
            z_test(noisy(1, 0.1f, 2 * seed), variance, noisy(1, 0.1f, 2 * seed + 1), variance);
        EXPECT_TRUE(test.agree()) << test.largest << " of " << test.threshold;
        EXPECT_EQ(test.comparisons, 3u * (5 * 3 + 1));
    }
}

TEST(ZTest, DifferencesAreDetected) {
    const FloatImage variance = constant(0.01f);
    const FloatImage a = noisy(1, 0.1f, 1);
    // 960 pixels: the standard error of the mean difference is 0.1 · sqrt(2 / 960) = 0.0046.
    const ZTest brighter = z_test(noisy(1.05f, 0.1f, 2), variance, a, variance);
    EXPECT_FALSE(brighter.agree());
    EXPECT_NEAR(brighter.whole[0], 0.05 / (0.1 * std::sqrt(2.0 / 960)), 4);
    // More noise than the variance says.
    EXPECT_FALSE(z_test(noisy(1, 0.3f, 2), variance, a, variance).agree());
    // A difference in one block only.
    FloatImage spot = noisy(1, 0.1f, 3);
    for (std::size_t y = 8; y < 16; ++y)
        for (std::size_t x = 8; x < 16; ++x)
            spot.pixels[y * kWidth + x][1] = 1.2f;
    const ZTest one = z_test(spot, variance, a, variance);
    EXPECT_EQ(one.beyond, 1u);
}

TEST(ZTest, ThresholdIsTheNormalQuantile) {
    const FloatImage zero = constant(0);
    const ZTest test = z_test(zero, zero, zero, zero);
    EXPECT_TRUE(test.agree());
    EXPECT_NEAR(std::erfc(test.threshold / std::sqrt(2.0)) * 48, kZTestLevel, 1e-9);
}

TEST(ZTest, RoundingIsAllowedWithoutVariance) {
    const FloatImage zero = constant(0);
    EXPECT_TRUE(z_test(constant(1), zero, constant(std::nextafter(1.0f, 2.0f)), zero).agree());
    EXPECT_FALSE(z_test(constant(1), zero, constant(1.001f), zero).agree());
}

TEST(ZTest, NonFinitePixelsAreExcluded) {
    const FloatImage variance = constant(0.01f);
    FloatImage a = noisy(1, 0.1f, 1);
    a.pixels[5][0] = std::nanf("");
    a.pixels[6][0] = std::numeric_limits<float>::infinity();
    const ZTest test = z_test(a, variance, noisy(1, 0.1f, 2), variance);
    EXPECT_TRUE(test.agree());
    EXPECT_TRUE(std::isfinite(test.largest) && test.largest > 0);
}

}  // namespace
}  // namespace hm
