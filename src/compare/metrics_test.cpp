#include "compare/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

TEST(CompareImages, KnownNumbers) {
    FloatImage a(2, 1);
    FloatImage b = a;
    EXPECT_EQ(compare_images(a, b).rmse, 0.0);
    a.pixels[0][0] = 2.0f;
    b.pixels[0][0] = 1.0f;
    b.pixels[1][2] = -3.0f;
    a.pixels[1][3] = 99.0f;  // alpha does not count
    const ImageError error = compare_images(a, b);
    EXPECT_DOUBLE_EQ(error.mse, (1.0 + 9.0) / 6.0);
    EXPECT_DOUBLE_EQ(error.rmse, std::sqrt(10.0 / 6.0));
    EXPECT_DOUBLE_EQ(error.relative_mse, (1.0 / 1.01 + 9.0 / 9.01) / 6.0);
    EXPECT_DOUBLE_EQ(error.max_abs, 3.0);
    // `b` is the reference.
    EXPECT_DOUBLE_EQ(compare_images(b, a).relative_mse, (1.0 / 4.01 + 9.0 / 0.01) / 6.0);
}

TEST(CompareImages, NanIsReported) {
    FloatImage a(2, 1);
    const FloatImage b = a;
    a.pixels[0][1] = std::nanf("");
    const ImageError error = compare_images(a, b);
    EXPECT_TRUE(std::isnan(error.mse) && std::isnan(error.rmse));
    EXPECT_TRUE(std::isnan(error.relative_mse) && std::isnan(error.max_abs));
}

TEST(Psnr, Decibels) {
    EXPECT_DOUBLE_EQ(psnr(1.0), 0.0);
    EXPECT_DOUBLE_EQ(psnr(1e-4), 40.0);
    EXPECT_TRUE(std::isinf(psnr(0.0)));
}

}  // namespace
}  // namespace hm
