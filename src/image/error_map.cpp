#include "image/error_map.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/check.h"
#include "image/metrics.h"

namespace hm {
namespace {

constexpr std::uint8_t kMagma[256][3] = {
#include "image/magma.inl"
};

template <class Error>
Plane per_pixel(const Image& a, const Image& b, Error error) {
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

Plane absolute_error(const Image& a, const Image& b) {
    Plane error = per_pixel(a, b, [](double x, double y) { return (x - y) * (x - y); });
    for (float& value : error.values)
        value = std::sqrt(value);
    return error;
}

Plane relative_squared_error(const Image& a, const Image& b) {
    return per_pixel(
        a, b, [](double x, double y) { return (x - y) * (x - y) / (y * y + kRelativeFloor); });
}

Image magma(const Plane& plane) {
    Image image{plane.width, plane.height, PixelFormat::rgba8, {}};
    image.pixels.reserve(plane.values.size() * 4);
    for (const float value : plane.values) {
        constexpr std::uint8_t kNotANumber[3] = {0, 255, 0};
        const std::uint8_t* const color =
            std::isnan(value) ? kNotANumber
                              : kMagma[std::size_t(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f)];
        for (std::size_t c = 0; c < 3; ++c)
            image.pixels.push_back(std::byte(color[c]));
        image.pixels.push_back(std::byte(255));
    }
    return image;
}

Image grey(const Plane& plane) {
    Image image{plane.width, plane.height, PixelFormat::rgba32f, {}};
    image.pixels.resize(plane.values.size() * 16);
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        const float v = plane.values[i];
        const float pixel[4] = {v, v, v, 1.0f};
        std::memcpy(&image.pixels[i * 16], pixel, 16);
    }
    return image;
}

}  // namespace hm
