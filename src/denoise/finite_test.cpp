#include "denoise/finite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace hm {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
const float kNan = std::nanf("");

TEST(ReplaceNonFinite, TakesTheMeanOfTheNeighbours) {
    std::vector<float> grey = {1, 2,    3,  //
                               4, kNan, 6,  //
                               7, 8,    9};
    EXPECT_EQ(replace_non_finite(grey, 3, 1), 1u);
    EXPECT_EQ(grey[4], 5.0f);
}

TEST(ReplaceNonFinite, BrokenNeighboursDoNotCount) {
    std::vector<float> grey = {kInf, kNan, 3, 4};
    EXPECT_EQ(replace_non_finite(grey, 4, 1), 2u);
    EXPECT_EQ(grey, (std::vector<float>{3, 3, 3, 4}));
}

TEST(ReplaceNonFinite, HolesAreFilledInwards) {
    constexpr std::size_t kSide = 12;
    std::vector<float> grey(kSide * kSide, 2.0f);
    for (std::size_t y = 2; y < 10; ++y)
        for (std::size_t x = 3; x < 11; ++x)
            grey[y * kSide + x] = kInf;
    EXPECT_EQ(replace_non_finite(grey, kSide, 1), 64u);
    EXPECT_EQ(grey, std::vector<float>(kSide * kSide, 2.0f));
    std::vector<float> nothing(4, kNan);
    EXPECT_EQ(replace_non_finite(nothing, 2, 1), 4u);
    EXPECT_EQ(nothing, std::vector<float>(4, 0.0f));
}

TEST(ReplaceNonFinite, APixelGoesAsAWhole) {
    std::vector<float> pixels = {1, kNan, 3, 10, 20, 30};
    EXPECT_EQ(replace_non_finite(pixels, 2, 3), 1u);
    EXPECT_EQ(pixels, (std::vector<float>{10, 20, 30, 10, 20, 30}));
}

TEST(ReplaceNonFinite, FiniteValuesStay) {
    std::vector<float> values = {-1, 3e38f, 0, 1e-40f};
    const std::vector<float> before = values;
    EXPECT_EQ(replace_non_finite(values, 2, 1), 0u);
    EXPECT_EQ(values, before);
}

}  // namespace
}  // namespace hm
