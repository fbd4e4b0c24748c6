// Single-channel images, for metrics and error maps.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace hm {

struct Plane {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<float> values;  // rows from top to bottom

    Plane() = default;
    Plane(std::uint32_t w, std::uint32_t h) : width(w), height(h), values(std::size_t(w) * h) {}
};

// R, G and B.
std::array<Plane, 3> color_planes(const FloatImage& image);

double mean(const Plane& plane);

// One-dimensional kernel, centred at index size() / 2.
using Kernel = std::vector<float>;

// Radius of a Gaussian kernel: three sigmas, rounded up to whole pixels.
int gaussian_radius(double sigma);
// exp(-x² / 2 sigma²) sampled at the integers from -radius to radius, normalized to sum 1.
Kernel gaussian_kernel(double sigma, int radius);

// Correlation along one axis with edge pixels repeated: kernel[middle + k] weights the pixel at
// offset k.
Plane filter_rows(const Plane& plane, const Kernel& kernel);
Plane filter_columns(const Plane& plane, const Kernel& kernel);

}  // namespace hm
