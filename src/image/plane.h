// One number per pixel: what metrics work on and error maps are made of.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace hm {

struct Plane {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<float> values;  // rows from the top

    Plane() = default;
    Plane(std::uint32_t w, std::uint32_t h) : width(w), height(h), values(std::size_t(w) * h) {}
};

// R, G and B.
std::array<Plane, 3> color_planes(const FloatImage& image);

double mean(const Plane& plane);

// One-dimensional kernel with its middle at values[values.size() / 2].
using Kernel = std::vector<float>;

// How far a Gaussian's kernel reaches: three sigmas, whole pixels.
int gaussian_radius(double sigma);
// Samples of exp(-x² / 2 sigma²) at the pixels from -radius to radius, with sum 1.
Kernel gaussian_kernel(double sigma, int radius);

// Convolution along one axis; beyond an edge the pixel at the edge goes on. The kernel is laid over
// the picture, not turned round: values[middle + k] weighs the pixel k further on.
Plane filter_rows(const Plane& plane, const Kernel& kernel);
Plane filter_columns(const Plane& plane, const Kernel& kernel);

}  // namespace hm
