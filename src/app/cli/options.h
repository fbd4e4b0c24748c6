// What the command line asks for, checked as far as that goes without the scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/compare.h"
#include "app/cli/denoise.h"
#include "app/cli/merge.h"
#include "base/result.h"
#include "film/film.h"
#include "film/tonemap.h"
#include "gltf/load.h"
#include "image/layers.h"
#include "shading/structs.h"
#include "shading/tables/tables.h"

namespace hm::cli {

// A float counts samples exactly up to here.
inline constexpr std::uint32_t kMaxSamples = 1u << 24;
inline constexpr std::uint32_t kMaxFrame = 9999999;

struct FrameRange {
    std::uint32_t first = 0, last = 0;  // both are drawn
};

struct DeviceFlag {
    enum class Kind { automatic, cpu, vulkan };
    Kind kind = Kind::automatic;
    std::optional<std::uint32_t> index;  // of vulkan:N
};

struct SampleRange {
    std::uint32_t begin = 0, end = 0;  // half-open
};

// Work that outlasts the program (docs/checkpoints.md).
struct KeepOptions {
    std::filesystem::path checkpoint;    // what --resume names unless it was given itself
    std::optional<float> every;          // seconds
    std::filesystem::path resume;        // empty: begin anew
    bool begin_if_missing = false;       // --checkpoint was given with the name of --resume
    bool any_device = false;             // the checkpoint may be another's
    std::optional<SampleRange> samples;  // none: all, from 0
};

struct ViewOptions {
    std::string camera;  // name or index; empty: the file's first
    std::optional<vec3> eye, target, up;
    std::optional<float> fov;  // vertical, degrees
    float aperture = 0;        // the lens' radius, metres
    std::optional<float> focus;
};

// What a picture carries beside the beauty, and how .exr files store it.
struct LayerOptions {
    std::vector<Aov> aovs;
    bool light_groups = false;      // as Aov::light_groups
    std::vector<std::string> half;  // see film/layers.h
    ExrOptions exr;
};

struct RenderOptions {
    std::string input;  // as given: a path or demo:NAME
    std::filesystem::path scene_file;
    LoadOptions load;
    std::vector<std::filesystem::path> outputs;

    std::uint32_t width = 1280, height = 720;
    std::optional<PixelRect> crop;
    std::uint32_t samples = 64;
    std::optional<float> time;  // seconds
    KeepOptions keep;
    std::uint32_t seed = 0;
    std::uint32_t sampler = kSamplerSobolOwen;
    std::uint32_t bounces = 8;  // 0: no limit
    float clamp = 0;            // 0: off
    PixelFilter filter = PixelFilter::blackman_harris;
    std::optional<float> filter_width;  // pixels
    std::uint32_t threads = 0;          // 0: all
    DeviceFlag device;

    ViewOptions view;

    std::string animation;    // name or index; empty: the file's first
    std::optional<float> at;  // seconds of the animation
    std::optional<FrameRange> frames;
    std::optional<std::uint32_t> frame;  // the one of a sequence that these options draw
    float fps = 24;

    std::string env;  // a path, "none", or empty: the default where the scene has no light
    float env_rotation = 0;
    float env_intensity = 1;
    std::uint32_t background = kBackgroundEnvironment;
    vec3 background_color{0};
    bool punctual = true;

    bool energy_compensation = true;
    std::uint32_t diffuse = kDiffuseLambert;
    std::uint32_t strategy = kStrategyMis;

    LayerOptions layers;

    bool denoise = false;
    DenoiseDevice denoise_device = DenoiseDevice::fastest;

    std::uint32_t tone_curve = kToneNeutral;
    std::optional<float> exposure = 0.0f;  // none: auto
    bool json = false;
    bool quiet = false;

    // Flags and values that shaped the picture, a demo's own first: for reports and metadata. The
    // value of a flag that takes none is empty.
    std::vector<std::pair<std::string, std::string>> given;

    std::uint32_t sample_end() const { return keep.samples ? keep.samples->end : samples; }
};

struct InfoOptions {
    std::string input;  // as given: a path or demo:NAME
    std::filesystem::path scene_file;
    LoadOptions load;
    bool json = false;
};

struct DoctorOptions {
    bool json = false;
};

struct BenchOptions {
    std::vector<std::string> inputs;  // paths or demo:NAME
    std::uint32_t width = 1920, height = 1080;
    DeviceFlag device;
};

struct CommandLine {
    std::optional<RenderOptions> render;
    std::optional<InfoOptions> info;
    std::optional<DoctorOptions> doctor;
    std::optional<BenchOptions> bench;
    std::optional<CompareOptions> compare;
    std::optional<DenoiseOptions> denoise;
    std::optional<MergeOptions> merge;
    std::string text;  // help or version, to be printed instead
};

// Fails with ErrorKind::invalid_argument, or with a demo's own error.
Result<CommandLine> parse_command_line(int count, const char* const* arguments);

// As `himalaya render` has them without flags, a demo's own included; no output.
Result<RenderOptions> default_render_options(const std::string& input);

}  // namespace hm::cli
