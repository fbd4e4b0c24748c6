#include "film/tonemap.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/check.h"
#include "shading/tables/tables.h"

namespace hm {
namespace {

constexpr float kMiddleGrey = 0.18f;
constexpr float kUnlitShare = 1e-3f;
constexpr double kMaxStops = 32;

vec4 load_pixel(const Image& linear, std::size_t i) {
    vec4 pixel;
    std::memcpy(&pixel, linear.pixels.data() + i * sizeof(vec4), sizeof(vec4));
    return pixel;
}

vec3 straight_color(vec4 pixel) {
    return pixel.w > 0.0f ? vec3(pixel) / pixel.w : vec3(0);
}

// In (-0.5, 0.5): the tile holds each rank once.
float dither_offset(std::uint32_t x, std::uint32_t y) {
    const std::uint32_t rank = shading_tables().blue_noise[(y & 127u) * 128u + (x & 127u)];
    return (float(rank) + 0.5f) / 16384.0f - 0.5f;
}

std::byte quantise(float value, float offset) {
    return std::byte(std::uint8_t(std::clamp(value * 255.0f + 0.5f + offset, 0.0f, 255.0f)));
}

}  // namespace

float auto_exposure(const Image& linear) {
    const std::size_t count = std::size_t(linear.width) * linear.height;
    double mean = 0, coverage = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const vec4 pixel = load_pixel(linear, i);
        mean += double(luminance(vec3(pixel)));
        coverage += double(pixel.w);
    }
    if (!(mean > 0) || !(coverage > 0)) return 0;
    const double unlit = double(kUnlitShare) * mean / coverage;
    double stops = 0, lit = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const vec4 pixel = load_pixel(linear, i);
        const double l = double(luminance(straight_color(pixel)));
        if (l <= unlit) continue;
        stops += double(pixel.w) * std::log2(l);
        lit += double(pixel.w);
    }
    if (!(lit > 0)) return 0;
    const double exposure = std::log2(double(kMiddleGrey)) - stops / lit;
    return float(std::clamp(exposure, -kMaxStops, kMaxStops));
}

Image tone_map_picture(const Image& linear, PixelRect crop, const ToneSettings& settings) {
    HM_CHECK(linear.format == PixelFormat::rgba32f && linear.width == crop.width() &&
                 linear.height == crop.height(),
             "{} x {} for {} x {}", linear.width, linear.height, crop.width(), crop.height());
    Image out{linear.width, linear.height, PixelFormat::rgba8, {}};
    out.pixels.resize(std::size_t(out.width) * out.height * 4);
    const float scale = std::exp2(settings.exposure);
    tbb::parallel_for(0u, linear.height, [&](std::uint32_t y) {
        for (std::uint32_t x = 0; x < linear.width; ++x) {
            const std::size_t i = std::size_t(y) * linear.width + x;
            const vec4 pixel = load_pixel(linear, i);
            const vec3 shown =
                linear_to_srgb3(tone_map(straight_color(pixel) * scale, settings.curve));
            const float offset = dither_offset(crop.x0 + x, crop.y0 + y);
            std::byte* texel = out.pixels.data() + i * 4;
            texel[0] = quantise(shown.x, offset);
            texel[1] = quantise(shown.y, offset);
            texel[2] = quantise(shown.z, offset);
            texel[3] = quantise(pixel.w, 0.0f);
        }
    });
    return out;
}

}  // namespace hm
