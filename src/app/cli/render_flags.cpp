#include "app/cli/render_flags.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/cli/flag.h"
#include "app/cli/frames.h"
#include "app/cli/keep_flags.h"
#include "app/cli/layer_flags.h"
#include "app/cli/load_flags.h"
#include "app/cli/output_flag.h"
#include "app/cli/tone_flags.h"
#include "app/cli/values.h"
#include "base/files.h"
#include "session/choices.h"

namespace hm::cli {
namespace {

auto number(float low, float high) {
    return [=](const std::string& text) { return parse_number(text, low, high); };
}
auto integer(std::uint32_t low, std::uint32_t high) {
    return [=](const std::string& text) { return parse_integer(text, low, high); };
}

// A parser of the names in a table.
template <class T, std::size_t N>
auto one_of(const Choice<T> (&choices)[N]) {
    return [&choices](const std::string& text) { return parse_choice(text, choices); };
}

void add_files(CLI::App& app, RenderOptions& o) {
    app.add_option("FILE", o.input,
                   "A .glb or .gltf file, or demo:NAME for a scene that is included")
        ->required();
    add_output_flag(
        app, o.outputs,
        "Where to write; may be repeated. .exr: linear, premultiplied floats. .png: exposed, "
        "tone "
        "mapped, 8-bit sRGB, straight alpha. .hdr: linear RGBE, no alpha");
    app.add_flag("--json", o.json, "Print one JSON report on standard output");
    app.add_flag("--quiet", o.quiet, "Print errors only");
}

void add_sampling(CLI::App& app, RenderOptions& o) {
    FrameSettings& frame = o.settings.frame;
    SamplingSettings& sampling = o.settings.sampling;
    PathSettings& path = o.settings.path;
    const auto store = [&frame](const std::string& text) {
        const Parsed<Size> size = parse_size(text);
        if (!size) throw CLI::ValidationError("--size", size.error());
        frame.width = size->width;
        frame.height = size->height;
    };
    app.add_option_function<std::string>("--size", store, "The picture's pixels (1280x720)")
        ->type_name("WxH");
    add(app, "--crop", "X0,Y0,X1,Y1", frame.crop, parse_crop,
        "Render and write only these pixels, X1 and Y1 excluded. They get the same samples as in "
        "the "
        "whole picture");
    add(app, "--spp", "N", sampling.samples, integer(1, kMaxSamples),
        "Samples per pixel (64; with --time alone as many as fit)");
    add(app, "--time", "SECONDS", sampling.time, number(0.001f, 1e9f),
        "Stop after this much wall-clock time of rendering, but not before each pixel has a "
        "sample; "
        "time before --resume counts");
    add(app, "--seed", "N", path.seed, integer(0, 0xffffffffu),
        "Seed of the random sequence: another seed, another noise (0)");
    add(app, "--sampler", "NAME", path.sampler, one_of(kSamplers),
        "independent, sobol-blue-noise or sobol-owen (the default)");
    add(app, "--bounces", "N", path.bounces, integer(0, 1000000),
        "Scattering events per path: 1 is direct light, 0 no limit (8)");
    add(app, "--clamp", "X", path.clamp, number(0, 1e15f),
        "Scale each contribution of an indirect bounce down to this. Fewer fireflies, less light; "
        "the metadata say how much less. 0: off (the default)");
    add(app, "--filter", "NAME", path.filter, one_of(kPixelFilters),
        "Pixel filter: box, gaussian (sigma is a quarter of the width) or blackman-harris (the "
        "default)");
    add(app, "--filter-width", "PX", path.filter_width, number(0, 64),
        "The filter's full width in pixels (box 1, gaussian 2, blackman-harris 3)");
    add(app, "--threads", "N", o.threads, integer(0, 1024),
        "Threads; 0: all cores (the default). The picture is the same for any number");
    add_device_flag(app, o.device);
}

void add_view(CLI::App& app, ViewSettings& v) {
    CLI::Option* camera = app.add_option(
        "--camera", v.camera,
        "The file's camera of this name or index (0), or none to frame the whole scene, as is done "
        "without cameras");
    camera->type_name("NAME|INDEX|none");
    CLI::Option* eye = add(app, "--eye", "X,Y,Z", v.eye, parse_vector,
                           "Look from this point, metres, instead of through a camera of the file");
    eye->excludes(camera);
    add(app, "--target", "X,Y,Z", v.target, parse_vector, "Look at this point (the scene's centre)")
        ->needs(eye);
    add(app, "--up", "X,Y,Z", v.up, parse_vector, "The up direction of the picture (0,1,0)")
        ->needs(eye);
    add(app, "--fov", "DEGREES", v.fov, number(0.01f, 179.0f),
        "Vertical field of view (the file's camera's, else 45)");
    add(app, "--aperture", "METRES", v.aperture, number(0, 1e6f),
        "Lens radius; 0: everything is in focus (the default)");
    add(app, "--focus", "METRES", v.focus, number(1e-6f, 1e15f),
        "Distance along the view axis that is in focus (--target, else the scene's centre)");
}

void add_animation(CLI::App& app, RenderOptions& o) {
    AnimationSettings& animation = o.settings.animation;
    app.add_option("--animation", animation.animation,
                   "The file's animation of this name or index (0), or all to play all together")
        ->type_name("NAME|INDEX|all");
    CLI::Option* at = add(
        app, "--at", "SECONDS", animation.at, number(-1e9f, 1e9f),
        "Time of the animation, which holds its first and last key outside of its range. Without "
        "--at and --animation the scene is rendered in its rest pose");
    add(app, "--frames", "A:B", o.frames, parse_frames,
        "Render a sequence, both ends included: frame n shows n / fps seconds. In the output names "
        "a run of # stands for the frame number, which also enters the seed")
        ->excludes(at);
    add(app, "--fps", "N", animation.fps, number(0.001f, 1e6f),
        "Frames per second of a sequence, and of the motion AOV (24)");
}

void add_light(CLI::App& app, RenderSettings& s) {
    LightSettings& light = s.light;
    const auto environment = [&light](const std::string& text) {
        light.environment = text.empty()     ? EnvironmentKind::automatic
                            : text == "none" ? EnvironmentKind::none
                                             : EnvironmentKind::file;
        light.environment_file = text;
    };
    app.add_option_function<std::string>(
           "--env", environment,
           "Equirectangular .hdr or .exr that lights the scene, or none for black. Without it a "
           "scene that has no punctual light gets a neutral sky")
        ->type_name("FILE|none");
    add(app, "--env-rotation", "DEGREES", light.environment_rotation, number(-36000, 36000),
        "Turn the environment about the vertical axis (0)");
    add(app, "--env-intensity", "X", light.environment_intensity, number(0, 1e9f),
        "Multiply the environment's radiance (1)");
    const auto background = [&path = s.path](const std::string& text) {
        path.background = kBackgroundEnvironment;
        if (text == "environment") return;
        path.background = text == "transparent" ? kBackgroundTransparent : kBackgroundColor;
        if (text == "transparent") return;
        const Parsed<vec3> color = parse_color(text);
        if (!color)
            throw CLI::ValidationError("--background",
                                       color.error() + ", environment or transparent");
        path.background_color = *color;
    };
    app.add_option_function<std::string>(
           "--background", background,
           "What is behind the scene: environment (the default), transparent, or a colour, linear "
           "R,G,B or sRGB #rrggbb; the environment lights the scene in any case")
        ->type_name("NAME|COLOR");
}

void add_shading(CLI::App& app, RenderSettings& s) {
    add(app, "--energy-compensation", "on|off", s.path.energy_compensation, one_of(kSwitches),
        "Keep the light that scatters more than once within a rough surface (on). off: glTF's "
        "Appendix B to the letter, for comparisons");
    add(app, "--diffuse", "NAME", s.path.diffuse, one_of(kDiffuseModels),
        "lambert (the default) or burley");
    add_tone_flags(app, s.display.exposure, s.display.tone_curve);
}

void add_denoising(CLI::App& app, DenoiseSettings& denoise) {
    CLI::Option* flag = app.add_flag(
        "--denoise", denoise.enabled,
        "Denoise the picture. .exr: the beauty stays as rendered, and the layers denoised, albedo "
        "and normal are added. .png and .hdr: the denoised picture");
    add_denoise_device(app, "--denoise-device", denoise.device)->needs(flag);
}

void add_checks(CLI::App& app, RenderSettings& s) {
    add(app, "--strategy", "NAME", s.path.strategy, one_of(kStrategies),
        "How light is found: by sampling lights, the BSDF or both (mis, the default). All three "
        "have the same mean");
    add(app, "--punctual", "on|off", s.light.punctual, one_of(kSwitches),
        "off: as if the file had no punctual lights (on)");
    add(app, "--light-units", "UNITS", s.light.units, one_of(kLightUnits),
        "blender: punctual lights were multiplied by 683 lm/W and emission was not, as Blender's "
        "exporter does in light mode Standard; they are divided by it. gltf: as they are (the "
        "default)");
}

// Under one heading of the help text.
template <class Add, class Options>
void add_group(CLI::App& app, const std::string& heading, Add add_all, Options& options) {
    const std::size_t before = app.get_options().size();
    add_all(app, options);
    const std::vector<CLI::Option*> all = app.get_options();
    for (std::size_t i = before; i < all.size(); ++i)
        all[i]->group(heading);
}

}  // namespace

void add_device_flag(CLI::App& app, DeviceChoice& device) {
    add(app, "--device", "NAME", device, parse_device,
        "Where to render: cpu, vulkan (the best GPU), vulkan:N (the device that `himalaya doctor` "
        "lists as N), or auto (the default): the best GPU, or the CPU if there is none");
}

void add_render_flags(CLI::App& app, RenderOptions& options) {
    add_group(app, "Files", add_files, options);
    add_group(app, "Scene", add_load_flags, options.load);
    add_group(app, "Sampling", add_sampling, options);
    add_group(app, "Long renderings", add_keep_flags, options);
    app.get_option("--samples")->excludes("--spp")->excludes("--time");
    add_group(app, "View", add_view, options.settings.view);
    add_group(app, "Animation", add_animation, options);
    add_group(app, "Light", add_light, options.settings);
    add_group(app, "Look", add_shading, options.settings);
    add_group(app, "Layers", add_layer_flags, options.settings.layers);
    add_group(app, "Denoising", add_denoising, options.settings.denoise);
    add_group(app, "For checking the renderer", add_checks, options.settings);
}

Result<void> check_render_options(const RenderOptions& o) {
    const auto usage = [](std::string message) {
        return fail(ErrorKind::invalid_argument, "", "", std::move(message));
    };
    HM_TRY(check_settings(o.settings));
    const bool has_fps = std::any_of(o.given.begin(), o.given.end(),
                                     [](const auto& flag) { return flag.first == "fps"; });
    const AnimationSettings& animation = o.settings.animation;
    if (has_fps && !o.frames && !animation.at && animation.animation.empty())
        return usage("--fps: needs --frames, --at or --animation");
    for (const std::filesystem::path& path : o.outputs) {
        if (o.frames && !has_frame_pattern(path))
            return usage(fmt::format("--frames: \"{}\" needs one run of # for the frame's number",
                                     path.string()));
        HM_TRY(check_writable(o.frames ? frame_path(path, o.frames->first) : path));
    }
    return check_keep_options(o);
}

}  // namespace hm::cli
