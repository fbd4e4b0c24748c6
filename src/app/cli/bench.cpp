#include "app/cli/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "app/cli/json_writer.h"
#include "app/cli/output.h"
#include "app/cli/prepared_scene.h"
#include "app/cli/progress.h"
#include "app/cli/vulkan_devices.h"
#include "base/machine.h"

namespace hm::cli {
namespace {

constexpr double kSecondsPerRound = 1;
constexpr int kRounds = 3;

// A stretch of drawing.
struct Round {
    std::uint64_t samples = 0, rays = 0;
    double seconds = 0;         // wall clock
    double device_seconds = 0;  // the device's own clock; 0 where it has none
};

struct SceneRates {
    RendererReport report;
    std::uint32_t samples_per_pixel = 0;  // of a round
    Round best;
    std::optional<TraceRates> traced;
};

double per_second(double count, double seconds) {
    return seconds > 0 ? count / seconds : 0;
}

Result<Round> draw(Renderer& renderer, std::uint32_t begin, std::uint32_t end) {
    RenderCounters counters;
    const std::atomic<bool> cancel{false};
    const double before = renderer.report().trace_seconds;
    const Clock::time_point start = Clock::now();
    HM_TRY(renderer.render(begin, end, counters, cancel));
    return Round{counters.samples.load(), counters.rays.load(), seconds_since(start),
                 renderer.report().trace_seconds - before};
}

// Rounds of as many samples as fill a second; the fastest counts. What comes before warms up.
Result<SceneRates> measure(Device& device, const PreparedScene& scene, std::uint32_t width,
                           std::uint32_t height) {
    HM_TRY_ASSIGN(const std::unique_ptr<Renderer> renderer, device.load(scene.flat));
    Film film({0, 0, width, height});
    HM_TRY(renderer->begin(scene.job, film));
    SceneRates rates;
    std::uint32_t done = 0, count = 1;
    for (;;) {
        HM_TRY_ASSIGN(const Round round, draw(*renderer, done, done + count));
        done += count;
        if (round.seconds >= kSecondsPerRound / 2) break;
        count *= 2;
    }
    rates.samples_per_pixel = count;
    for (int i = 0; i < kRounds; ++i) {
        HM_TRY_ASSIGN(const Round round, draw(*renderer, done, done + count));
        done += count;
        if (i == 0 || round.seconds < rates.best.seconds) rates.best = round;
    }
    HM_TRY(renderer->sync());
    rates.report = renderer->report();
    HM_TRY_ASSIGN(rates.traced, device.trace_rates(scene.flat, scene.job));
    return rates;
}

// Of one sample, all by the device's clock, so that the two sides are of one kind.
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
    if (r.traced) write_traced(json, *r.traced);
    json.end_object();
}

// auto takes a GPU if there is one. Nothing is replaced later: that would measure another device.
Result<std::unique_ptr<Device>> open_device(const DeviceFlag& wanted, Diagnostics& diagnostics) {
    if (wanted.kind == DeviceFlag::Kind::cpu) return cpu_device(0);
    Result<std::unique_ptr<Device>> gpu = open_vulkan_device(wanted.index, diagnostics);
    if (!gpu && wanted.kind == DeviceFlag::Kind::automatic) return cpu_device(0);
    return gpu;
}

}  // namespace

Result<ExitCode> bench(const BenchOptions& options) {
    Progress progress(false);
    Diagnostics diagnostics;
    HM_TRY_ASSIGN(const std::unique_ptr<Device> device, open_device(options.device, diagnostics));
    JsonWriter json;
    json.begin_object().field("cpu", cpu_model()).field("threads", cpu_threads());
    json.field("commit", build_commit()).field("compiler", __VERSION__);
    json.key("size").begin_array().value(options.width).value(options.height).end_array();
    json.key("scenes").begin_array();
    for (const std::string& input : options.inputs) {
        HM_TRY_ASSIGN(RenderOptions drawing, default_render_options(input));
        drawing.width = options.width;
        drawing.height = options.height;
        progress.note(fmt::format("{} on {}", input, device->name()));
        HM_TRY_ASSIGN(const std::unique_ptr<PreparedScene> scene,
                      prepare_scene(drawing, diagnostics));
        HM_TRY_ASSIGN(const SceneRates rates,
                      measure(*device, *scene, options.width, options.height));
        write_scene(json, input, rates);
    }
    json.end_array().end_object();
    for (const Warning& warning : diagnostics.warnings())
        progress.warning(warning.line());
    HM_TRY(print(json.text() + "\n"));
    return ExitCode::ok;
}

}  // namespace hm::cli
