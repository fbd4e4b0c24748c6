#include "output/tonemap.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "shading/tables/tables.h"

namespace hm {
namespace {

constexpr float kMiddleGrey = 0.18f;
constexpr float kUnlitShare = 1e-3f;
constexpr double kMaxStops = 32;

vec3 color(const Rgba<float>& pixel) {
    return vec3(pixel[0], pixel[1], pixel[2]);
}

vec3 straight_color(const Rgba<float>& pixel) {
    return pixel[3] > 0.0f ? color(pixel) / pixel[3] : vec3(0);
}

// In (-0.5, 0.5). Each rank occurs once in the tile.
float dither_offset(std::uint32_t x, std::uint32_t y) {
    const std::uint32_t rank = shading_tables().blue_noise[(y & 127u) * 128u + (x & 127u)];
    return (float(rank) + 0.5f) / 16384.0f - 0.5f;
}

std::uint8_t quantise(float value, float offset) {
    return std::uint8_t(std::clamp(value * 255.0f + 0.5f + offset, 0.0f, 255.0f));
}

}  // namespace

float auto_exposure(const FloatImage& linear) {
    double mean = 0, coverage = 0;
    for (const Rgba<float>& pixel : linear.pixels) {
        mean += double(luminance(color(pixel)));
        coverage += double(pixel[3]);
    }
    if (!(mean > 0) || !(coverage > 0)) return 0;
    const double unlit = double(kUnlitShare) * mean / coverage;
    double stops = 0, lit = 0;
    for (const Rgba<float>& pixel : linear.pixels) {
        const double l = double(luminance(straight_color(pixel)));
        if (l <= unlit) continue;
        stops += double(pixel[3]) * std::log2(l);
        lit += double(pixel[3]);
    }
    if (!(lit > 0)) return 0;
    const double exposure = std::log2(double(kMiddleGrey)) - stops / lit;
    return float(std::clamp(exposure, -kMaxStops, kMaxStops));
}

Image8 tone_map_picture(const FloatImage& linear, PixelRect crop, const ToneSettings& settings) {
    HM_CHECK(linear.width == crop.width() && linear.height == crop.height(), "{} x {} for {} x {}",
             linear.width, linear.height, crop.width(), crop.height());
    Image8 out(linear.width, linear.height);
    const float scale = std::exp2(settings.exposure);
    tbb::parallel_for(0u, linear.height, [&](std::uint32_t y) {
        for (std::uint32_t x = 0; x < linear.width; ++x) {
            const std::size_t i = std::size_t(y) * linear.width + x;
            const Rgba<float>& pixel = linear.pixels[i];
            const vec3 shown =
                linear_to_srgb3(tone_map(straight_color(pixel) * scale, settings.curve));
            const float offset = dither_offset(crop.x0 + x, crop.y0 + y);
            out.pixels[i] = {quantise(shown.x, offset), quantise(shown.y, offset),
                             quantise(shown.z, offset), quantise(pixel[3], 0.0f)};
        }
    });
    return out;
}

ToneShares tone_shares(const Image8& picture) {
    std::size_t black = 0, clipped = 0;
    for (const Rgba<std::uint8_t>& pixel : picture.pixels) {
        const std::uint8_t largest = std::max({pixel[0], pixel[1], pixel[2]});
        if (largest <= 1) ++black;
        if (largest >= 254) ++clipped;
    }
    const double count = double(std::max<std::size_t>(picture.pixels.size(), 1));
    return {double(black) / count, double(clipped) / count};
}

}  // namespace hm
