#include "denoise/mirror.h"

#include <algorithm>
#include <cstddef>

namespace hm {
namespace {

// Of 0, 1, ..., n - 1, n - 1, ..., 1, 0, 0, 1, ...: the pixel at an edge is repeated once.
std::size_t reflect(std::ptrdiff_t at, std::uint32_t n) {
    const std::ptrdiff_t period = 2 * std::ptrdiff_t(n);
    const std::ptrdiff_t within = ((at % period) + period) % period;
    return std::size_t(std::min(within, period - 1 - within));
}

}  // namespace

FloatImage mirrored(const FloatImage& image, std::uint32_t side) {
    FloatImage out(std::max(image.width, side), std::max(image.height, side));
    const std::ptrdiff_t x0 = (out.width - image.width) / 2, y0 = (out.height - image.height) / 2;
    for (std::size_t y = 0; y < out.height; ++y)
        for (std::size_t x = 0; x < out.width; ++x)
            out.pixels[y * out.width + x] =
                image.pixels[reflect(std::ptrdiff_t(y) - y0, image.height) * image.width +
                             reflect(std::ptrdiff_t(x) - x0, image.width)];
    return out;
}

FloatImage middle(const FloatImage& image, std::uint32_t width, std::uint32_t height) {
    FloatImage out(width, height);
    const std::size_t x0 = (image.width - width) / 2, y0 = (image.height - height) / 2;
    for (std::size_t y = 0; y < height; ++y)
        std::copy_n(image.pixels.begin() + std::ptrdiff_t((y + y0) * image.width + x0), width,
                    out.pixels.begin() + std::ptrdiff_t(y * width));
    return out;
}

}  // namespace hm
