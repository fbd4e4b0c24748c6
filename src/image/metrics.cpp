#include "image/metrics.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/check.h"

namespace hm {
namespace {

std::vector<float> colors(const Image& image) {
    const std::size_t pixels = std::size_t(image.width) * image.height;
    HM_CHECK(image.format == PixelFormat::rgba32f, "format {}", unsigned(image.format));
    HM_CHECK(pixels > 0 && image.pixels.size() == pixels * 16, "{} pixels, {} bytes", pixels,
             image.pixels.size());
    std::vector<float> values(pixels * 3);
    for (std::size_t i = 0; i < pixels; ++i)
        std::memcpy(&values[i * 3], &image.pixels[i * 16], 12);
    return values;
}

}  // namespace

ImageError compare_values(std::span<const float> a, std::span<const float> b) {
    HM_CHECK(a.size() == b.size() && !a.empty(), "{} and {} values", a.size(), b.size());
    ImageError error;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double reference = double(b[i]);
        const double difference = double(a[i]) - reference;
        const double square = difference * difference;
        error.mse += square;
        error.relative_mse += square / (reference * reference + kRelativeFloor);
        error.max_abs = std::max(error.max_abs, std::abs(difference));
    }
    error.mse /= double(a.size());
    error.relative_mse /= double(a.size());
    error.rmse = std::sqrt(error.mse);
    if (std::isnan(error.mse)) error.max_abs = error.mse;  // std::max passes over NaN
    return error;
}

ImageError compare_images(const Image& a, const Image& b) {
    HM_CHECK(a.width == b.width && a.height == b.height, "{} x {} and {} x {} pixels", a.width,
             a.height, b.width, b.height);
    return compare_values(colors(a), colors(b));
}

double psnr(double mse) {
    return -10.0 * std::log10(mse);
}

}  // namespace hm
