#include "compare/metrics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"

namespace hm {
namespace {

std::vector<float> colors(const FloatImage& image) {
    const std::size_t pixels = std::size_t(image.width) * image.height;
    HM_CHECK(pixels > 0 && image.pixels.size() == pixels, "{} x {}, {} pixels", image.width,
             image.height, image.pixels.size());
    std::vector<float> values;
    values.reserve(pixels * 3);
    for (const Rgba<float>& pixel : image.pixels)
        values.insert(values.end(), pixel.begin(), pixel.begin() + 3);
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
    if (std::isnan(error.mse)) error.max_abs = error.mse;  // std::max ignores NaN
    return error;
}

ImageError compare_images(const FloatImage& a, const FloatImage& b) {
    HM_CHECK(a.width == b.width && a.height == b.height, "{} x {} and {} x {} pixels", a.width,
             a.height, b.width, b.height);
    return compare_values(colors(a), colors(b));
}

double psnr(double mse) {
    return -10.0 * std::log10(mse);
}

}  // namespace hm
