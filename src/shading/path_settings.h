// What decides how paths are sampled and shaded, with defaults that give a correct picture. C++
// only: scene/render_params.h makes what the stages read of it.
#pragma once

#include <cstdint>
#include <optional>

#include "shading/structs.h"
#include "shading/tables/tables.h"

namespace hm {

struct PathSettings {
    std::uint32_t seed = 0;
    std::uint32_t sampler = kSamplerSobolOwen;
    std::uint32_t bounces = 8;  // scattering events; 0: no limit
    float clamp = 0;            // largest contribution of an indirect bounce; 0: off
    std::uint32_t strategy = kStrategyMis;
    bool energy_compensation = true;
    std::uint32_t diffuse = kDiffuseLambert;
    std::uint32_t background = kBackgroundEnvironment;
    vec3 background_color{0};  // linear
    PixelFilter filter = PixelFilter::blackman_harris;
    std::optional<float> filter_width{};  // pixels; none: default_filter_width
};

constexpr float default_filter_width(PixelFilter filter) {
    return filter == PixelFilter::box ? 1.0f : filter == PixelFilter::gaussian ? 2.0f : 3.0f;
}

}  // namespace hm
