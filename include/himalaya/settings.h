// Everything that decides a picture beside its scene. The defaults give a good one.
#pragma once

#include <himalaya/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace himalaya {

// Half-open, in pixels of the whole picture.
struct Crop {
    std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct FrameSettings {
    std::uint32_t width = 1280, height = 720;
    std::optional<Crop> crop{};  // render these pixels only
};

enum class Sampler { independent, sobol_blue_noise, sobol_owen };
enum class Filter { box, gaussian, blackman_harris };

struct SamplingSettings {
    std::uint32_t samples = 64;          // per pixel
    std::optional<double> time_limit{};  // seconds; each pixel gets a sample in any case
    std::uint32_t seed = 0;
    Sampler sampler = Sampler::sobol_owen;
    std::uint32_t bounces = 8;  // scattering events per path; 0: no limit
    float clamp = 0;            // largest contribution of an indirect bounce; 0: off
    Filter filter = Filter::blackman_harris;
    std::optional<float> filter_width{};  // pixels
};

struct ViewSettings {
    // Name or index; "none": frame the scene; empty: the first camera, or frame the scene.
    std::string camera{};
    std::optional<Vec3d> eye{}, target{};  // instead of a camera of the scene, metres
    std::optional<Vec3> up{};
    std::optional<float> vertical_fov{};    // degrees
    float lens_radius = 0;                  // metres; 0: everything is in focus
    std::optional<float> focus_distance{};  // metres
};

enum class Environment {
    automatic,  // a neutral sky if the scene has no punctual light
    none,       // black
    file,
};
enum class Background { environment, transparent, color };

struct LightSettings {
    Environment environment = Environment::automatic;
    std::filesystem::path environment_file{};  // equirectangular .hdr or .exr
    float environment_rotation = 0;            // degrees about the vertical axis
    float environment_intensity = 1;
    Background background = Background::environment;
    Vec3 background_color{};  // linear Rec.709
};

struct AnimationSettings {
    std::string animation{};      // name or index; "all": all together; empty: the first
    std::optional<float> time{};  // seconds; none: rest pose unless an animation is named
};

enum class ToneCurve { neutral, aces, agx, linear };

// How PNG files show radiance.
struct DisplaySettings {
    ToneCurve tone_curve = ToneCurve::neutral;
    std::optional<float> exposure = 0.0f;  // EV; none: automatic
};

struct RenderSettings {
    FrameSettings frame{};
    SamplingSettings sampling{};
    ViewSettings view{};
    LightSettings light{};
    AnimationSettings animation{};
    DisplaySettings display{};
    bool energy_compensation = true;  // light scattered more than once within a rough surface
    std::vector<std::string> aovs{};  // "albedo", "depth", ...: see docs/aovs.md; or "all"
    bool denoise = false;             // needs Open Image Denoise
};

}  // namespace himalaya
