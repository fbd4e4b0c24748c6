// Errors between two pictures: MSE, relative MSE, PSNR.
#pragma once

#include <span>

#include "image/image.h"

namespace hm {

// Added to the squared reference in relative errors, which keeps them finite where it is black.
inline constexpr double kRelativeFloor = 1e-2;

struct ImageError {
    double mse = 0.0;
    double rmse = 0.0;
    double relative_mse = 0.0;  // mean of (a - b)^2 / (b^2 + kRelativeFloor)
    double max_abs = 0.0;
};

// `b` is the reference and has the size of `a`. A NaN in either makes every result NaN.
ImageError compare_values(std::span<const float> a, std::span<const float> b);

// Over R, G and B of two pictures of the same size.
ImageError compare_images(const FloatImage& a, const FloatImage& b);

// Peak signal-to-noise ratio in decibels for a peak of 1; infinite if mse is 0.
double psnr(double mse);

}  // namespace hm
