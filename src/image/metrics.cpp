#include "image/metrics.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/check.h"

namespace hm {

ImageError compare_images(const Image& a, const Image& b) {
    HM_CHECK(a.width == b.width && a.height == b.height, "{} x {} and {} x {} pixels", a.width,
             a.height, b.width, b.height);
    HM_CHECK(a.format == PixelFormat::rgba32f && b.format == PixelFormat::rgba32f,
             "formats {} and {}", unsigned(a.format), unsigned(b.format));
    const std::size_t pixels = std::size_t(a.width) * a.height;
    HM_CHECK(pixels > 0 && a.pixels.size() == pixels * 16 && b.pixels.size() == pixels * 16,
             "{} pixels, {} and {} bytes", pixels, a.pixels.size(), b.pixels.size());

    // Keeps the relative error finite where the reference is black.
    constexpr double kRelativeFloor = 1e-2;
    ImageError error;
    for (std::size_t i = 0; i < pixels; ++i) {
        float from_a[4], from_b[4];
        std::memcpy(from_a, &a.pixels[i * 16], 16);
        std::memcpy(from_b, &b.pixels[i * 16], 16);
        for (std::size_t c = 0; c < 3; ++c) {
            const double reference = double(from_b[c]);
            const double difference = double(from_a[c]) - reference;
            const double square = difference * difference;
            error.mse += square;
            error.relative_mse += square / (reference * reference + kRelativeFloor);
            error.max_abs = std::max(error.max_abs, std::abs(difference));
        }
    }
    const double count = 3.0 * double(pixels);
    error.mse /= count;
    error.relative_mse /= count;
    error.rmse = std::sqrt(error.mse);
    if (std::isnan(error.mse)) error.max_abs = error.mse;  // std::max passes over NaN
    return error;
}

}  // namespace hm
