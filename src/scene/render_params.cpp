#include "scene/render_params.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hm {

RenderParams make_params(const FlatScene& scene, std::uint32_t width, std::uint32_t height,
                         const PathSettings& s) {
    RenderParams p{};
    p.width = width;
    p.height = height;
    p.seed = s.seed;
    p.sampler_kind = s.sampler;
    p.max_bounces = s.bounces;
    p.max_radiance = s.clamp;
    p.strategy = s.strategy;
    p.energy_compensation = s.energy_compensation ? 1 : 0;
    p.diffuse_kind = s.diffuse;
    p.background = s.background;
    p.background_color = s.background_color;
    p.filter_width = s.filter_width.value_or(default_filter_width(s.filter));
    set_light_ranges(scene, p);
    return p;
}

void set_light_ranges(const FlatScene& scene, RenderParams& params) {
    params.light_count = std::uint32_t(scene.lights.size());
    params.emitter_count = std::uint32_t(scene.emitters.size());
    std::array<LightRange*, 3> ranges = {&params.environment_range, &params.punctual_range,
                                         &params.emitter_range};
    std::array<double, 3> powers = {scene.environment_power, scene.punctual_power,
                                    scene.emitter_power};
    // BSDF sampling cannot hit a punctual light, so those are sampled in every strategy.
    if (params.strategy == kStrategyBsdf) powers[0] = powers[2] = 0;
    double total = 0;
    int present = 0;
    for (double p : powers) {
        total += p;
        present += p > 0 ? 1 : 0;
    }
    double begin = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        *ranges[i] = LightRange{};
        if (!(powers[i] > 0)) continue;
        // Half by power, half uniform: power alone is a poor predictor of the light at a point.
        double share = 0.5 * powers[i] / total + 0.5 / present;
        double end = std::min(begin + share, 1.0);
        double low = std::floor(begin * 4294967295.0), high = std::floor(end * 4294967295.0);
        if (end > 1.0 - 1e-9) high = 4294967295.0;
        double scale = 4294967295.0 / (high - low);
        *ranges[i] = {std::uint32_t(low), std::uint32_t(high), std::uint32_t(scale),
                      std::uint32_t((scale - std::floor(scale)) * 4294967296.0),
                      float((high - low) / 4294967295.0)};
        begin = end;
    }
}

}  // namespace hm
