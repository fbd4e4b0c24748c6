#include "compare/error_map.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "compare/metrics.h"

namespace hm {
namespace {

constexpr std::uint8_t kMagma[256][3] = {
#include "compare/magma.inl"
};

template <class Error>
Plane per_pixel(const FloatImage& a, const FloatImage& b, Error error) {
    const auto planes_a = color_planes(a), planes_b = color_planes(b);
    HM_CHECK(a.width == b.width && a.height == b.height, "{} x {} and {} x {} pixels", a.width,
             a.height, b.width, b.height);
    Plane out(a.width, a.height);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c)
            sum += error(double(planes_a[c].values[i]), double(planes_b[c].values[i]));
        out.values[i] = float(sum / 3);
    }
    return out;
}

}  // namespace

Plane absolute_error(const FloatImage& a, const FloatImage& b) {
    Plane error = per_pixel(a, b, [](double x, double y) { return (x - y) * (x - y); });
    for (float& value : error.values)
        value = std::sqrt(value);
    return error;
}

Plane relative_squared_error(const FloatImage& a, const FloatImage& b) {
    return per_pixel(
        a, b, [](double x, double y) { return (x - y) * (x - y) / (y * y + kRelativeFloor); });
}

Image8 magma(const Plane& plane) {
    Image8 image(plane.width, plane.height);
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        constexpr std::uint8_t kNanColor[3] = {0, 255, 0};
        const float value = plane.values[i];
        const std::uint8_t* const color =
            std::isnan(value) ? kNanColor
                              : kMagma[std::size_t(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f)];
        image.pixels[i] = {color[0], color[1], color[2], 255};
    }
    return image;
}

FloatImage grey(const Plane& plane) {
    FloatImage image(plane.width, plane.height);
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        const float v = plane.values[i];
        image.pixels[i] = {v, v, v, 1.0f};
    }
    return image;
}

}  // namespace hm
