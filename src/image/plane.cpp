#include "image/plane.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace hm {

std::array<Plane, 3> color_planes(const FloatImage& image) {
    const std::size_t count = std::size_t(image.width) * image.height;
    HM_CHECK(image.pixels.size() == count, "{} x {}, {} pixels", image.width, image.height,
             image.pixels.size());
    std::array<Plane, 3> planes;
    planes.fill(Plane(image.width, image.height));
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < count; ++i)
            planes[c].values[i] = image.pixels[i][c];
    return planes;
}

double mean(const Plane& plane) {
    double sum = 0;
    for (const float value : plane.values)
        sum += double(value);
    return plane.values.empty() ? 0 : sum / double(plane.values.size());
}

int gaussian_radius(double sigma) {
    return int(std::ceil(3 * sigma));
}

Kernel gaussian_kernel(double sigma, int radius) {
    Kernel kernel;
    double sum = 0;
    for (int x = -radius; x <= radius; ++x)
        sum += std::exp(-0.5 * x * x / (sigma * sigma));
    for (int x = -radius; x <= radius; ++x)
        kernel.push_back(float(std::exp(-0.5 * x * x / (sigma * sigma)) / sum));
    return kernel;
}

Plane filter_rows(const Plane& plane, const Kernel& kernel) {
    Plane out(plane.width, plane.height);
    const std::size_t radius = kernel.size() / 2, width = plane.width;
    tbb::parallel_for(std::size_t(0), std::size_t(plane.height), [&](std::size_t y) {
        const float* const row = plane.values.data() + y * width;
        // A copy padded with edge pixels, so that the loop over pixels has no branches.
        std::vector<float> wide(width + 2 * radius);
        std::fill_n(wide.begin(), radius, row[0]);
        std::copy_n(row, width, wide.begin() + std::ptrdiff_t(radius));
        std::fill(wide.end() - std::ptrdiff_t(radius), wide.end(), row[width - 1]);
        float* const to = out.values.data() + y * width;
        for (std::size_t k = 0; k < kernel.size(); ++k)
            for (std::size_t x = 0; x < width; ++x)
                to[x] += kernel[k] * wide[x + k];
    });
    return out;
}

Plane filter_columns(const Plane& plane, const Kernel& kernel) {
    Plane out(plane.width, plane.height);
    const auto radius = std::ptrdiff_t(kernel.size() / 2), height = std::ptrdiff_t(plane.height);
    const std::size_t width = plane.width;
    tbb::parallel_for(std::ptrdiff_t(0), height, [&](std::ptrdiff_t y) {
        float* const to = out.values.data() + std::size_t(y) * width;
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const std::ptrdiff_t at =
                std::clamp(y + std::ptrdiff_t(k) - radius, std::ptrdiff_t(0), height - 1);
            const float* const from = plane.values.data() + std::size_t(at) * width;
            for (std::size_t x = 0; x < width; ++x)
                to[x] += kernel[k] * from[x];
        }
    });
    return out;
}

}  // namespace hm
