// All settings of a picture besides its scene, with good defaults. Front ends fill it from flags, a
// form or another language.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "denoise/denoise.h"
#include "film/film.h"
#include "image/layers.h"
#include "shading/color.h"
#include "shading/path_settings.h"

namespace hm {

// A float counts samples exactly up to here.
inline constexpr std::uint32_t kMaxSamples = 1u << 24;

struct FrameSettings {
    std::uint32_t width = 1280, height = 720;  // pixels
    std::optional<PixelRect> crop;

    PixelRect pixels() const { return crop.value_or(PixelRect{0, 0, width, height}); }
    float aspect() const { return float(width) / float(height); }
};

struct SampleRange {
    std::uint32_t begin = 0, end = 0;  // half-open
};

struct SamplingSettings {
    std::uint32_t samples = 64;        // per pixel
    std::optional<double> time;        // seconds of rendering after which to stop
    std::optional<SampleRange> range;  // of the samples, to render a part; none: all, from 0

    std::uint32_t end() const { return range ? range->end : samples; }
};

// ViewSettings::camera that frames the whole scene. A camera of that name is chosen by its index.
inline constexpr std::string_view kNoCamera = "none";

struct ViewSettings {
    std::string camera;                     // name, index or kNoCamera; empty: the file's first
    std::optional<glm::dvec3> eye, target;  // in the file's coordinates
    std::optional<vec3> up;
    std::optional<float> fov;  // vertical, degrees
    float aperture = 0;        // lens radius, metres
    std::optional<float> focus;
};

// AnimationSettings::animation that plays all of the file together. An animation of that name is
// chosen by its index.
inline constexpr std::string_view kAllAnimations = "all";

struct AnimationSettings {
    std::string animation;    // name, index or kAllAnimations; empty: the file's first
    std::optional<float> at;  // seconds of the animation
    float fps = 24;
    std::optional<std::uint32_t> frame;  // number within a sequence
};

enum class EnvironmentKind {
    automatic,  // a neutral sky where no punctual light is used
    none,       // black
    file,
};

// What the intensities of a file's punctual lights are.
enum class LightUnits {
    gltf,     // as they are, in the unit of emission
    blender,  // its exporter multiplied them by 683 lm/W, and emission not (light mode "Standard")
};

struct LightSettings {
    EnvironmentKind environment = EnvironmentKind::automatic;
    std::filesystem::path environment_file;
    float environment_rotation = 0;  // degrees about the vertical axis
    float environment_intensity = 1;
    bool punctual = true;
    LightUnits units = LightUnits::gltf;
};

// The layers of a picture besides the beauty, and how .exr files store them.
struct LayerSettings {
    std::vector<Aov> aovs;
    bool light_groups = false;      // as Aov::light_groups
    std::vector<std::string> half;  // see film/layers.h
    ExrOptions exr;
};

struct DenoiseSettings {
    bool enabled = false;
    DenoiseDevice device = DenoiseDevice::fastest;
};

struct DisplaySettings {
    std::uint32_t tone_curve = kToneNeutral;
    std::optional<float> exposure = 0.0f;  // EV; none: automatic
};

struct RenderSettings {
    FrameSettings frame;
    SamplingSettings sampling;
    PathSettings path;
    ViewSettings view;
    AnimationSettings animation;
    LightSettings light;
    LayerSettings layers;
    DenoiseSettings denoise;
    DisplaySettings display;
};

// Which device renders.
struct DeviceChoice {
    enum class Kind { automatic, cpu, vulkan };
    Kind kind = Kind::automatic;
    std::optional<std::uint32_t> index;  // among Vulkan's devices; none: the best
};

// Work that outlasts the process (docs/checkpoints.md).
struct KeepSettings {
    std::filesystem::path checkpoint;  // empty: none is written
    std::optional<float> every;        // seconds
    std::filesystem::path resume;      // empty: start anew
    bool begin_if_missing = false;     // `resume` may not exist yet
    bool any_device = false;           // the checkpoint may be another device's
};

// Whether the settings fit together and fit this machine's memory. Fails with
// ErrorKind::invalid_argument, naming the setting.
Result<void> check_settings(const RenderSettings& settings);

// The settings for one frame of a sequence: its time and its seed.
RenderSettings settings_of_frame(const RenderSettings& settings, std::uint32_t number);

}  // namespace hm
