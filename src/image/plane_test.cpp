#include "image/plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace hm {
namespace {

TEST(Plane, FiltersCarryTheEdgesOn) {
    Plane plane(3, 2);
    plane.values = {1, 2, 4, 10, 20, 40};
    // Weights: 1 for the previous pixel, 10 for the pixel itself, 100 for the next.
    const Kernel kernel = {1, 10, 100};
    EXPECT_EQ(filter_rows(plane, kernel).values,
              (std::vector<float>{211, 421, 442, 2110, 4210, 4420}));
    EXPECT_EQ(filter_columns(plane, kernel).values,
              (std::vector<float>{1011, 2022, 4044, 1101, 2202, 4404}));
}

TEST(Plane, AGaussianKernelIsOne) {
    const Kernel kernel = gaussian_kernel(1.5, gaussian_radius(1.5));
    ASSERT_EQ(kernel.size(), 11u);
    EXPECT_NEAR(std::accumulate(kernel.begin(), kernel.end(), 0.0), 1.0, 1e-6);
    EXPECT_FLOAT_EQ(kernel[5] / kernel[8], std::exp(2.0f));  // exp(3² / (2 · 1.5²))
    EXPECT_EQ(kernel[0], kernel[10]);
}

TEST(Plane, MeanOfValues) {
    Plane plane(2, 1);
    plane.values = {1, 4};
    EXPECT_EQ(mean(plane), 2.5);
    EXPECT_EQ(mean(Plane()), 0.0);
}

}  // namespace
}  // namespace hm
