#include "app/cli/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "app/cli/bench_report.h"
#include "app/cli/drivers.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "base/clock.h"
#include "base/json_writer.h"
#include "base/machine.h"
#include "session/prepared_scene.h"
#include "session/vulkan_devices.h"

namespace hm::cli {
namespace {

constexpr double kSecondsPerRound = 1;
constexpr int kRounds = 3;

Result<Round> draw(Renderer& renderer, std::uint32_t begin, std::uint32_t end) {
    RenderCounters counters;
    const std::atomic<bool> cancel{false};
    const double before = renderer.report().trace_seconds;
    const Clock::time_point start = Clock::now();
    HM_TRY(renderer.render(begin, end, counters, cancel));
    return Round{counters.samples.load(), counters.rays.load(), seconds_since(start),
                 renderer.report().trace_seconds - before};
}

// Rounds of about a second each, after a warm-up; the fastest counts.
Result<SceneRates> measure(RenderDevice& device, const PreparedScene& scene, std::uint32_t width,
                           std::uint32_t height) {
    HM_TRY_ASSIGN(const std::unique_ptr<Renderer> renderer, device.load(scene.setup.flat));
    Film film({0, 0, width, height});
    HM_TRY(renderer->begin(scene.setup.job, film));
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
    HM_TRY_ASSIGN(rates.traced, device.trace_rates(scene.setup.flat, scene.setup.job));
    return rates;
}

// auto takes a GPU if there is one. No fallback later: that would measure another device.
Result<std::unique_ptr<RenderDevice>> open_device(const DeviceChoice& wanted,
                                                  Diagnostics& diagnostics) {
    if (wanted.kind == DeviceChoice::Kind::cpu) return cpu_device(0);
    add_hidden_drivers();
    Result<std::unique_ptr<RenderDevice>> gpu = open_vulkan_device(wanted.index, diagnostics);
    if (!gpu && wanted.kind == DeviceChoice::Kind::automatic) return cpu_device(0);
    return gpu;
}

}  // namespace

Result<ExitCode> bench(const BenchOptions& options) {
    Progress progress(false);
    Diagnostics diagnostics;
    HM_TRY_ASSIGN(const std::unique_ptr<RenderDevice> device,
                  open_device(options.device, diagnostics));
    JsonWriter json;
    write_machine(json.begin_object());
    json.key("size").begin_array().value(options.width).value(options.height).end_array();
    json.key("scenes").begin_array();
    for (const std::string& input : options.inputs) {
        HM_TRY_ASSIGN(RenderOptions drawing, default_render_options(input));
        drawing.settings.frame.width = options.width;
        drawing.settings.frame.height = options.height;
        progress.note(fmt::format("{} on {}", input, device->name()));
        HM_TRY_ASSIGN(
            const std::unique_ptr<PreparedScene> scene,
            prepare_scene(drawing.scene_file, drawing.load, drawing.settings, diagnostics));
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
