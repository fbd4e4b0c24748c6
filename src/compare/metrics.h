// Errors between two pictures: MSE, relative MSE, PSNR.
#pragma once

#include <span>

#include "image/image.h"

namespace hm {

// Added to the squared reference in relative errors, so that they stay finite where it is black.
inline constexpr double kRelativeFloor = 1e-2;

struct ImageError {
    double mse = 0.0;
    double rmse = 0.0;
    double relative_mse = 0.0;  // mean of (a - b)^2 / (b^2 + kRelativeFloor)
    double max_abs = 0.0;
};

// Value by value; `b` is the reference, as long as `a`. A NaN in either makes every number NaN.
ImageError compare_values(std::span<const float> a, std::span<const float> b);

// Over R, G and B of two pictures of the same size.
ImageError compare_images(const FloatImage& a, const FloatImage& b);

// Peak signal-to-noise ratio in decibels of values whose largest is 1; infinite where mse is 0.
double psnr(double mse);

}  // namespace hm
