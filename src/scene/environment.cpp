#include "scene/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/alias_table.h"
#include "shading/math.h"

namespace hm {
namespace {

// The mean of the bilinear lookup over a texel's cell: a 3x3 filter with weights 1 6 1 along each
// axis.
float cell_luminance(const std::vector<float>& lum, std::uint32_t w, std::uint32_t h,
                     std::uint32_t x, std::uint32_t y) {
    const std::uint32_t xs[3] = {x == 0 ? w - 1 : x - 1, x, x + 1 == w ? 0 : x + 1};
    const std::uint32_t ys[3] = {y == 0 ? 0 : y - 1, y, y + 1 == h ? y : y + 1};
    const float weights[3] = {0.125f, 0.75f, 0.125f};
    float sum = 0;
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
            sum += weights[i] * weights[j] * lum[std::size_t(ys[j]) * w + xs[i]];
    return sum;
}

}  // namespace

EnvironmentMap make_environment(const FloatImage& image, float rotation, float intensity) {
    EnvironmentMap map;
    const std::uint32_t w = image.width, h = image.height;
    map.data = {w, h, rotation / 360.0f, intensity};
    map.texels.reserve(image.pixels.size());
    for (const Rgba<float>& pixel : image.pixels)
        map.texels.push_back(vec4(pixel[0], pixel[1], pixel[2], pixel[3]));

    std::vector<float> lum(map.texels.size());
    for (std::size_t i = 0; i < lum.size(); ++i)
        lum[i] = luminance(vec3(map.texels[i]));
    std::vector<float> weights(lum.size());
    double total = 0;
    for (std::uint32_t y = 0; y < h; ++y) {
        // Solid angle of a texel in this row, as a fraction of the sphere.
        double top = std::cos(std::numbers::pi * y / h);
        double bottom = std::cos(std::numbers::pi * (y + 1) / h);
        double share = (top - bottom) / (2.0 * w);
        for (std::uint32_t x = 0; x < w; ++x) {
            double weight = double(cell_luminance(lum, w, h, x, y)) * share;
            weights[std::size_t(y) * w + x] = float(weight);
            total += weight;
        }
    }
    map.mean_radiance = float(total) * intensity;
    if (!(map.mean_radiance > 0)) map.data.intensity = 0;
    map.alias = build_alias_table(weights);
    return map;
}

FloatImage default_environment() {
    FloatImage image(128, 64);
    const vec3 key = normalize(vec3(-0.5f, 0.75f, 0.45f));
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x) {
            vec2 theta = cos_sin_2pi(0.5f * (float(y) + 0.5f) / float(image.height));
            vec2 phi = cos_sin_2pi(fract((float(x) + 0.5f) / float(image.width) + 0.5f));
            vec3 d(theta.y * phi.x, theta.x, theta.y * phi.y);
            float sky = 0.42f + 0.22f * d.y;
            float glow = 3.4f * std::exp(-(1.0f - dot(d, key)) * 14.0f);
            float value = sky + glow;
            image.pixels[std::size_t(y) * image.width + x] = {value, value, value, 1};
        }
    return image;
}

}  // namespace hm
