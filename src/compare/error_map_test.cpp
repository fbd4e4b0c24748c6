#include "compare/error_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

TEST(ErrorMap, PerPixelNumbers) {
    FloatImage a(2, 1), b = a;
    a.pixels[0][0] = 2.0f;
    b.pixels[0][0] = 1.0f;
    a.pixels[1][3] = 5.0f;  // alpha does not count
    const Plane absolute = absolute_error(a, b), relative = relative_squared_error(a, b);
    EXPECT_FLOAT_EQ(absolute.values[0], std::sqrt(1.0f / 3.0f));
    EXPECT_FLOAT_EQ(relative.values[0], 1.0f / 1.01f / 3.0f);
    EXPECT_EQ(absolute.values[1], 0.0f);
    EXPECT_EQ(relative.values[1], 0.0f);
}

TEST(ErrorMap, MagmaFromBlackToYellow) {
    Plane plane(5, 1);
    plane.values = {0.0f, 1.0f, 7.0f, -1.0f, std::nanf("")};
    const Image8 image = magma(plane);
    const auto color = [&](std::size_t i) {
        return std::array{image.pixels[i][0], image.pixels[i][1], image.pixels[i][2]};
    };
    const std::array<std::uint8_t, 3> black{0, 0, 4}, yellow{252, 253, 191}, green{0, 255, 0};
    EXPECT_EQ(color(0), black);
    EXPECT_EQ(color(1), yellow);
    EXPECT_EQ(color(2), yellow);
    EXPECT_EQ(color(3), black);
    EXPECT_EQ(color(4), green);
}

TEST(ErrorMap, GreyKeepsTheNumbers) {
    Plane plane(1, 1);
    plane.values = {12.5f};
    const FloatImage image = grey(plane);
    EXPECT_EQ(image.pixels[0][0], 12.5f);
    EXPECT_EQ(image.pixels[0][2], 12.5f);
    EXPECT_EQ(image.pixels[0][3], 1.0f);
}

}  // namespace
}  // namespace hm
