// Properties of FLIP that follow from its definition. tests/flip compares it with the published
// package.
#include "compare/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

FloatImage filled(float r, float g, float b) {
    FloatImage image(24, 20);
    for (std::size_t i = 0; i < 24 * 20; ++i) {
        image.pixels[i] = {r, g, b, 1.0f};
    }
    return image;
}

TEST(Flip, EqualPicturesHaveNoError) {
    const FloatImage image = filled(0.2f, 0.5f, 0.7f);
    EXPECT_EQ(mean(ldr_flip(image, image)), 0.0);
    EXPECT_EQ(mean(hdr_flip(image, image).error), 0.0);
}

// Flat pictures have no features, so only the distance of the colours counts. Black and white
// differ by 100 in lightness; green and blue have the largest possible distance.
TEST(Flip, DistancesOfFlatColors) {
    const double green_blue = std::pow(203.301655, 0.7);  // their HyAB distance, computed by hand
    const double black_white = std::pow(100.0, 0.7);
    const double knee = 0.4 * green_blue;
    ASSERT_GT(black_white, knee);
    EXPECT_NEAR(mean(ldr_flip(filled(0, 0, 0), filled(1, 1, 1))),
                0.95 + (black_white - knee) / (green_blue - knee) * 0.05, 1e-5);
    EXPECT_NEAR(mean(ldr_flip(filled(0, 1, 0), filled(0, 0, 1))), 1.0, 1e-5);
}

TEST(Flip, LdrClampsToTheDisplayRange) {
    EXPECT_EQ(mean(ldr_flip(filled(1, 1, 1), filled(7, 2, 1))), 0.0);
    EXPECT_GT(mean(hdr_flip(filled(1, 1, 1), filled(7, 2, 1)).error), 0.1);
}

TEST(Flip, ExposuresFollowTheReference) {
    // The brightest and the median pixel are equal: the same exposure is compared twice.
    const HdrFlip one = hdr_flip(filled(0.5f, 0.5f, 0.5f), filled(3, 3, 3));
    EXPECT_EQ(one.exposures, 2u);
    EXPECT_DOUBLE_EQ(one.start_exposure, one.stop_exposure);
    // Twice the radiance needs one stop less.
    const HdrFlip twice = hdr_flip(filled(1, 1, 1), filled(3, 3, 3));
    EXPECT_NEAR(twice.start_exposure, one.start_exposure - 1, 1e-6);
    FloatImage bright = filled(0.5f, 0.5f, 0.5f);
    bright.pixels[7][1] = 0.5f + 31.5f / 0.7152f;  // a luminance of 32
    const HdrFlip many = hdr_flip(bright, bright);
    EXPECT_NEAR(many.stop_exposure - many.start_exposure, 6, 1e-5);
    EXPECT_NEAR(many.stop_exposure, one.stop_exposure, 1e-6);
    // A black reference must not cause a division by zero.
    const HdrFlip black = hdr_flip(filled(0, 0, 0), filled(1, 1, 1));
    EXPECT_TRUE(std::isfinite(black.start_exposure));
    EXPECT_GT(mean(black.error), 0.9);
}

TEST(Flip, SmallPicturesWork) {
    const FloatImage image(1, 1);
    EXPECT_EQ(ldr_flip(image, image).values.size(), 1u);
    FloatImage dot = filled(0, 0, 0);
    dot.pixels[10 * 24 + 12][1] = 1.0f;
    const Plane error = ldr_flip(filled(0, 0, 0), dot);
    // The contrast filter blurs: neighbours differ too, but less than the pixel itself.
    const float there = error.values[10 * 24 + 12], beside = error.values[10 * 24 + 14];
    EXPECT_GT(there, beside);
    EXPECT_GT(beside, 0.01f);
    EXPECT_LE(*std::max_element(error.values.begin(), error.values.end()), 1.0f);
}

}  // namespace
}  // namespace hm
