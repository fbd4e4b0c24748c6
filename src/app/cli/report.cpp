#include "app/cli/report.h"

#include <fmt/format.h>

#include "base/json_writer.h"
#include "session/choices.h"

namespace hm::cli {
namespace {

double per_second(std::uint64_t count, double seconds) {
    return seconds > 0 ? double(count) / seconds : 0;
}

// Those given as flags, then those in effect.
void write_settings(JsonWriter& json, const RenderOptions& o, const RenderSummary& summary) {
    json.key("flags").begin_object();
    for (const auto& [flag, value] : o.given)
        value.empty() ? json.field(flag, true) : json.field(flag, value);
    json.end_object().key("settings").begin_object();
    const FrameSettings& frame = o.settings.frame;
    const PathSettings& path = o.settings.path;
    const PixelRect crop = frame.pixels();
    json.field("width", frame.width).field("height", frame.height).key("crop").begin_array();
    json.value(crop.x0).value(crop.y0).value(crop.x1).value(crop.y1).end_array();
    json.field("seed", path.seed).field("sampler", std::string(name_of(kSamplers, path.sampler)));
    json.field("bounces", path.bounces).field("clamp", double(path.clamp));
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

std::string flags_text(const NamedValues& values) {
    std::string text;
    for (const auto& [flag, value] : values)
        text += (text.empty() ? "--" : " --") + flag + (value.empty() ? "" : " " + value);
    return text;
}

MetadataTexts metadata_texts(const RenderOptions& options, const RenderSummary& summary) {
    const std::string flags = flags_text(options.given);
    return {options.input + (flags.empty() ? "" : " " + flags), flags_text(summary.view)};
}

std::string json_report(const RenderOptions& options, const RenderSummary& summary,
                        const Diagnostics& diagnostics) {
    JsonWriter json;
    json.begin_object();
    json.field("program", "himalaya " HIMALAYA_VERSION);
    json.field("input", options.input).field("scene_file", options.scene_file.string());
    write_settings(json, options, summary);
    json.field("camera", summary.camera).field("view", flags_text(summary.view));
    json.field("environment", summary.environment)
        .field("bias", bias_text(options.settings.path, summary));
    write_scene(json, summary.scene);
    write_renderer(json, summary.renderer);
    write_times(json, summary);
    json.field("samples_per_pixel", summary.samples_per_pixel);
    json.field("samples", summary.samples).field("rays", summary.rays);
    json.field("samples_per_second", per_second(summary.samples, summary.times.render));
    json.field("rays_per_second", per_second(summary.rays, summary.times.render));
    json.field("non_finite_samples", summary.non_finite);
    json.field("clamp_removed_share", summary.removed_share());
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
