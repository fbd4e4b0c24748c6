#include "app/cli/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/json_writer.h"
#include "film/variance.h"

namespace hm::cli {
namespace {

const char* sampler_name(std::uint32_t kind) {
    return kind == kSamplerIndependent      ? "independent"
           : kind == kSamplerSobolBlueNoise ? "sobol-blue-noise"
                                            : "sobol-owen";
}

double per_second(std::uint64_t count, double seconds) {
    return seconds > 0 ? double(count) / seconds : 0;
}

double removed_share(const RenderSummary& s) {
    const double all = s.removed_luminance + s.mean_luminance;
    return all > 0 ? s.removed_luminance / all : 0;
}

std::string bias(const RenderOptions& options, const RenderSummary& summary) {
    const std::string events =
        options.bounces == 0
            ? ""
            : fmt::format(" up to {} event{}", options.bounces, options.bounces == 1 ? "" : "s");
    if (options.clamp == 0) return "unbiased" + events;
    return fmt::format("clamped at {:g}, removed {:.3g} % of luminance{}", options.clamp,
                       100 * removed_share(summary), events.empty() ? "" : ";" + events);
}

std::string settings_line(const RenderOptions& options) {
    std::string line = options.input;
    for (const auto& [flag, value] : options.given)
        line += " --" + flag + (value.empty() ? "" : " " + value);
    return line;
}

// As they were used: those given as flags, then what holds in any case.
void write_settings(JsonWriter& json, const RenderOptions& o, const RenderSummary& summary) {
    json.key("flags").begin_object();
    for (const auto& [flag, value] : o.given)
        value.empty() ? json.field(flag, true) : json.field(flag, value);
    json.end_object().key("settings").begin_object();
    const PixelRect crop = o.crop.value_or(PixelRect{0, 0, o.width, o.height});
    json.field("width", o.width).field("height", o.height).key("crop").begin_array();
    json.value(crop.x0).value(crop.y0).value(crop.x1).value(crop.y1).end_array();
    json.field("seed", o.seed).field("sampler", sampler_name(o.sampler));
    json.field("bounces", o.bounces).field("clamp", double(o.clamp));
    json.field("exposure", double(summary.exposure)).field("threads", o.threads);
    json.end_object();
}

void write_scene(JsonWriter& json, const SceneStats& s) {
    json.key("scene").begin_object();
    json.field("meshes", s.meshes).field("instances", s.instances);
    json.field("materials", s.materials).field("images", s.images);
    json.field("triangles", s.triangles).field("punctual_lights", s.punctual_lights);
    json.field("emissive_triangles", s.emissive_triangles).end_object();
}

void write_renderer(JsonWriter& json, const RendererReport& r) {
    json.key("device").begin_object();
    json.field("kind", r.kind).field("name", r.device).field("variant", r.variant);
    json.field("bytes", r.device_bytes).end_object();
    json.key("acceleration_structure").begin_object();
    for (const auto& [name, count] : r.structure)
        json.field(name, count);
    json.field("bytes", r.structure_bytes).end_object();
}

void write_times(JsonWriter& json, const RenderSummary& s) {
    json.key("seconds").begin_object();
    json.field("load", s.times.load).field("flatten", s.times.flatten);
    json.field("upload", s.renderer.upload_seconds).field("build", s.renderer.build_seconds);
    json.field("prepare", s.times.prepare).field("render", s.times.render);
    json.field("denoise", s.times.denoise);
    json.field("write", s.times.write).end_object();
}

}  // namespace

SceneStats scene_stats(const Scene& scene, const FlatScene& flat) {
    SceneStats s;
    s.meshes = scene.meshes.size();
    s.instances = flat.instances.size();
    s.materials = scene.materials.size();
    s.images = scene.images.size();
    for (const InstanceData& i : flat.instances)
        for (std::size_t g = i.first_geometry; g < flat.mesh_first_geometry[i.mesh + 1]; ++g)
            s.triangles += flat.geometries[g].triangle_count;
    s.punctual_lights = flat.lights.size();
    s.emissive_triangles = flat.emitters.size();
    return s;
}

RenderSummary with_samples(RenderSummary summary, const Film& film, const RenderCounters& counters,
                           double seconds, const std::string& devices) {
    summary.renderer.device = devices;
    summary.times.render = seconds;
    summary.samples = counters.samples.load();
    summary.rays = counters.rays.load();
    summary.non_finite = counters.non_finite.load();
    summary.samples_per_pixel = film.mean_samples();
    summary.removed_luminance = film.removed_luminance();
    summary.mean_luminance = film.mean_luminance();
    summary.estimated_error = estimated_error(film);
    return summary;
}

// The seconds aside, nothing here depends on the clock, and on the machine only what bits depend
// on.
Metadata picture_metadata(const RenderOptions& options, const RenderSummary& summary) {
    Metadata metadata = {
        {"software", "Himalaya " HIMALAYA_VERSION},
        {"settings", settings_line(options)},
        {"samplesPerPixel", fmt::format("{:g}", summary.samples_per_pixel)},
        {"seed", fmt::format("{}", options.seed)},
        {"sampler", sampler_name(options.sampler)},
        {"bounces", options.bounces == 0 ? "no limit" : fmt::format("{}", options.bounces)},
        {"bias", bias(options, summary)},
        {"colorSpace", "linear Rec.709"},
        {"camera", summary.camera},
        {"view", summary.view},
        {"exposure", fmt::format("{:g} EV, PNG only", summary.exposure)},
        {"environment", summary.environment},
        {"sceneHash", summary.scene_hash},
        {"device", summary.renderer.device},
        {"renderSeconds", fmt::format("{:.3f}", summary.times.render)},
        {"clamp", options.clamp == 0 ? "off" : fmt::format("{:g}", options.clamp)},
        {"clampRemovedShare", fmt::format("{:g}", removed_share(summary))}};
    if (summary.estimated_error)
        metadata.emplace_back("estimatedError", fmt::format("{:g}", *summary.estimated_error));
    const auto& aovs = options.layers.aovs;
    if (std::find(aovs.begin(), aovs.end(), Aov::variance) != aovs.end())
        metadata.emplace_back("varianceFrom", options.sampler == kSamplerIndependent
                                                  ? "samples"
                                                  : fmt::format("{} replicates", kReplicates));
    return metadata;
}

std::string json_report(const RenderOptions& options, const RenderSummary& summary,
                        const Diagnostics& diagnostics) {
    JsonWriter json;
    json.begin_object();
    json.field("program", "himalaya " HIMALAYA_VERSION);
    json.field("input", options.input).field("scene_file", options.scene_file.string());
    write_settings(json, options, summary);
    json.field("camera", summary.camera).field("view", summary.view);
    json.field("environment", summary.environment).field("bias", bias(options, summary));
    write_scene(json, summary.scene);
    write_renderer(json, summary.renderer);
    write_times(json, summary);
    json.field("samples_per_pixel", summary.samples_per_pixel);
    json.field("samples", summary.samples).field("rays", summary.rays);
    json.field("samples_per_second", per_second(summary.samples, summary.times.render));
    json.field("rays_per_second", per_second(summary.rays, summary.times.render));
    json.field("non_finite_samples", summary.non_finite);
    json.field("clamp_removed_share", removed_share(summary));
    json.field("mean_luminance", summary.mean_luminance);
    if (summary.estimated_error) json.field("estimated_error", *summary.estimated_error);
    if (!summary.denoiser.empty()) json.field("denoiser", summary.denoiser);
    json.field("interrupted", summary.interrupted);
    json.key("outputs").begin_array();
    for (const std::filesystem::path& path : options.outputs)
        json.value(path.string());
    json.end_array().key("warnings").begin_array();
    for (const Warning& warning : diagnostics.warnings())
        json.value(warning.line());
    json.end_array().end_object();
    return json.text() + "\n";
}

std::string summary_line(const RenderSummary& s) {
    return fmt::format(
        "{}{:.6g} samples/pixel on {}, {:.2f} Mrays/s; load {:.2f} s, prepare {:.2f} s, "
        "render {:.2f} s, {}write {:.2f} s",
        s.interrupted ? "interrupted at " : "", s.samples_per_pixel, s.renderer.device,
        per_second(s.rays, s.times.render) * 1e-6, s.times.load + s.times.flatten, s.times.prepare,
        s.times.render,
        s.denoiser.empty() ? "" : fmt::format("denoise {:.2f} s, ", s.times.denoise),
        s.times.write);
}

}  // namespace hm::cli
