#include "app/cli/bench_report.h"

namespace hm::cli {
namespace {

double per_second(double count, double seconds) {
    return seconds > 0 ? count / seconds : 0;
}

// One sample with hits reordered before shading; null if the device does not support it.
void write_reordered(JsonWriter& json, const TracedRates& traced) {
    json.key("reordered");
    if (!traced.reordered) {
        json.null();
        return;
    }
    const TraceRates& t = *traced.reordered;
    json.begin_object().field("sorts", traced.sorts).field("gpu_milliseconds", t.path_ms);
    json.field("rays_per_second", per_second(double(t.rays()), t.path_ms * 1e-3));
    json.field("share_of_bare_rate", t.path_ms > 0 ? t.bare_ms / t.path_ms : 0);
    json.field("speedup", t.path_ms > 0 ? traced.rates.path_ms / t.path_ms : 0).end_object();
}

// Of one sample, all by the device's clock, so that both are comparable.
void write_traced(JsonWriter& json, const TraceRates& t) {
    const double rays = double(t.rays()), closest = double(t.closest_rays);
    const auto rate = [](double count, double ms) { return per_second(count, ms * 1e-3); };
    json.key("one_sample").begin_object();
    json.field("closest_rays", t.closest_rays).field("shadow_rays", t.shadow_rays);
    json.field("gpu_milliseconds", t.path_ms);
    json.field("rays_per_second", rate(rays, t.path_ms));
    json.field("closest_rays_per_second", rate(closest, t.path_ms));
    json.field("shadow_rays_per_second", rate(rays - closest, t.path_ms)).end_object();
    json.key("several_samples").begin_object().field("samples", t.several);
    json.key("gpu_milliseconds_per_sample").begin_object();
    for (const auto& [way, ms] : t.ways)
        json.field(way, ms);
    json.end_object().end_object();
    json.key("bare").begin_object();
    json.field("rays_per_second", rate(rays, t.bare_ms));
    json.field("closest_rays_per_second", rate(closest, t.bare_closest_ms));
    json.field("shadow_rays_per_second", rate(rays - closest, t.bare_shadow_ms));
    json.field("rays_per_second_in_path_order", rate(rays, t.bare_loop_ms)).end_object();
    json.field("share_of_bare_rate", t.path_ms > 0 ? t.bare_ms / t.path_ms : 0);
    json.field("share_of_bare_rate_in_path_order", t.path_ms > 0 ? t.bare_loop_ms / t.path_ms : 0);
}

}  // namespace

void write_scene(JsonWriter& json, const std::string& name, const SceneRates& r) {
    const double samples = double(r.best.samples), rays = double(r.best.rays);
    json.begin_object().field("scene", name).field("device", r.report.device);
    json.field("driver", r.report.variant);
    if (!r.report.launches.empty()) json.field("launches", r.report.launches);
    json.key("acceleration_structure").begin_object();
    for (const auto& [part, count] : r.report.structure)
        json.field(part, count);
    json.field("bytes", r.report.structure_bytes).end_object();
    json.field("upload_seconds", r.report.upload_seconds);
    json.field("build_seconds", r.report.build_seconds);
    json.field("device_bytes", r.report.device_bytes);
    json.field("samples_per_pixel", r.samples_per_pixel).field("seconds", r.best.seconds);
    json.field("samples_per_second", per_second(samples, r.best.seconds));
    json.field("rays_per_second", per_second(rays, r.best.seconds));
    json.field("rays_per_sample", rays / samples);
    json.field("milliseconds_per_sample", r.best.seconds * 1e3 / r.samples_per_pixel);
    if (r.best.device_seconds > 0)
        json.field("gpu_milliseconds_per_sample",
                   r.best.device_seconds * 1e3 / r.samples_per_pixel);
    if (r.traced) {
        write_traced(json, r.traced->rates);
        write_reordered(json, *r.traced);
    }
    json.end_object();
}

}  // namespace hm::cli
