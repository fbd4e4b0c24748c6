#include "library/settings.h"

#include <cmath>

#include "library/errors.h"

namespace himalaya {
namespace {

std::optional<hm::vec3> to_glm(const std::optional<Vec3>& v) {
    return v ? std::optional<hm::vec3>({v->x, v->y, v->z}) : std::nullopt;
}

std::optional<glm::dvec3> to_glm(const std::optional<Vec3d>& v) {
    return v ? std::optional<glm::dvec3>({v->x, v->y, v->z}) : std::nullopt;
}

std::uint32_t sampler_of(Sampler sampler) {
    return sampler == Sampler::independent        ? hm::kSamplerIndependent
           : sampler == Sampler::sobol_blue_noise ? hm::kSamplerSobolBlueNoise
                                                  : hm::kSamplerSobolOwen;
}

hm::PixelFilter filter_of(Filter filter) {
    return filter == Filter::box        ? hm::PixelFilter::box
           : filter == Filter::gaussian ? hm::PixelFilter::gaussian
                                        : hm::PixelFilter::blackman_harris;
}

std::uint32_t tone_curve_of(ToneCurve curve) {
    return curve == ToneCurve::aces     ? hm::kToneAces
           : curve == ToneCurve::agx    ? hm::kToneAgx
           : curve == ToneCurve::linear ? hm::kToneLinear
                                        : hm::kToneNeutral;
}

hm::PathSettings path_of(const RenderSettings& s) {
    const Vec3& background = s.light.background_color;
    return {.seed = s.sampling.seed,
            .sampler = sampler_of(s.sampling.sampler),
            .bounces = s.sampling.bounces,
            .clamp = s.sampling.clamp,
            .energy_compensation = s.energy_compensation,
            .background = s.light.background == Background::transparent ? hm::kBackgroundTransparent
                          : s.light.background == Background::color     ? hm::kBackgroundColor
                                                                    : hm::kBackgroundEnvironment,
            .background_color = {background.x, background.y, background.z},
            .filter = filter_of(s.sampling.filter),
            .filter_width = s.sampling.filter_width};
}

hm::LightSettings light_of(const LightSettings& light) {
    hm::LightSettings result;
    result.environment = light.environment == Environment::none   ? hm::EnvironmentKind::none
                         : light.environment == Environment::file ? hm::EnvironmentKind::file
                                                                  : hm::EnvironmentKind::automatic;
    result.environment_file = light.environment_file;
    result.environment_rotation = light.environment_rotation;
    result.environment_intensity = light.environment_intensity;
    return result;
}

std::vector<hm::Aov> aovs_of(const std::vector<std::string>& names) {
    if (names.empty()) return {};
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ",") + name;
    auto aovs = hm::parse_aovs(list);
    if (!aovs) throw Error(ErrorKind::invalid_argument, aovs.error(), {}, {}, "aovs");
    return std::move(*aovs);
}

void check_number(double value, double low, double high, const char* setting) {
    if (!(value >= low && value <= high))
        throw Error(ErrorKind::invalid_argument, "is out of range or not finite", {}, {}, setting);
}

// The range checks that the command line does when it parses flags.
void check(const RenderSettings& s) {
    constexpr double kMost = 1e15;
    if (s.sampling.samples == 0 || s.sampling.samples > hm::kMaxSamples)
        throw Error(ErrorKind::invalid_argument, "must be from 1 to 16777216", {}, {}, "samples");
    check_number(double(s.sampling.clamp), 0, kMost, "clamp");
    check_number(double(s.sampling.filter_width.value_or(1)), 0, 64, "filter_width");
    check_number(double(s.view.vertical_fov.value_or(45)), 0.01, 179, "vertical_fov");
    check_number(double(s.view.lens_radius), 0, 1e6, "lens_radius");
    check_number(double(s.view.focus_distance.value_or(1)), 1e-6, kMost, "focus_distance");
    check_number(double(s.light.environment_rotation), -36000, 36000, "environment_rotation");
    check_number(double(s.light.environment_intensity), 0, 1e9, "environment_intensity");
    check_number(double(s.animation.time.value_or(0)), -1e9, 1e9, "time");
    check_number(double(s.display.exposure.value_or(0)), -32, 32, "exposure");
    const Vec3d eye = s.view.eye.value_or(Vec3d()), target = s.view.target.value_or(Vec3d());
    const Vec3 up = s.view.up.value_or(Vec3());
    for (const double x : {eye.x, eye.y, eye.z, target.x, target.y, target.z, double(up.x),
                           double(up.y), double(up.z)})
        check_number(x, -kMost, kMost, "view");
    const Vec3& background = s.light.background_color;
    for (const float x : {background.x, background.y, background.z})
        check_number(double(x), 0, kMost, "background_color");
}

}  // namespace

hm::RenderSettings to_session(const RenderSettings& s) {
    check(s);
    hm::RenderSettings result;
    result.frame.width = s.frame.width;
    result.frame.height = s.frame.height;
    if (s.frame.crop)
        result.frame.crop = {s.frame.crop->x0, s.frame.crop->y0, s.frame.crop->x1,
                             s.frame.crop->y1};
    result.sampling.samples = s.sampling.samples;
    result.sampling.time = s.sampling.time_limit;
    result.path = path_of(s);
    result.view = {s.view.camera,        to_glm(s.view.eye),  to_glm(s.view.target),
                   to_glm(s.view.up),    s.view.vertical_fov, s.view.lens_radius,
                   s.view.focus_distance};
    result.animation.animation = s.animation.animation;
    result.animation.at = s.animation.time;
    result.light = light_of(s.light);
    result.layers.aovs = aovs_of(s.aovs);
    result.denoise.enabled = s.denoise;
    result.display.tone_curve = tone_curve_of(s.display.tone_curve);
    result.display.exposure = s.display.exposure;
    value_or_throw(hm::check_settings(result));
    return result;
}

}  // namespace himalaya
