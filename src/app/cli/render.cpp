// The way a picture travels: load, flatten, put it on a device, render in passes, resolve, write.
#include "app/cli/render.h"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "app/cli/denoise.h"
#include "app/cli/devices.h"
#include "app/cli/fallback.h"
#include "app/cli/frames.h"
#include "app/cli/interrupt.h"
#include "app/cli/keeper.h"
#include "app/cli/output.h"
#include "app/cli/outputs.h"
#include "app/cli/passes.h"
#include "app/cli/picture_setup.h"
#include "app/cli/vulkan_devices.h"
#include "film/tonemap.h"
#include "gltf/load.h"

namespace hm::cli {
namespace {

void note_defaults(Progress& progress, const RenderSummary& summary) {
    if (summary.environment == "default")
        progress.note(
            "the scene has no punctual light: using the default environment (--env none "
            "for black)");
    if (summary.camera == "framing")
        progress.note("the file has no camera: framing the whole scene (see --eye)");
}

// What the frames of a sequence share.
struct Shared {
    std::unique_ptr<Device> device;
    std::optional<Denoiser> denoiser;
    Scene scene;
    double load_seconds = 0;  // told with the first picture
    std::optional<EnvironmentChoice> environment{};
    std::optional<Checkpoint> resumed{};  // the first picture's
};

PassHooks hooks(const Film& film, Keeper& keeper, Progress& progress) {
    bool told = false;
    return {.stop = interrupted,
            .watch =
                [&progress, told](const ProgressState& state) mutable {
                    if (interrupted() && !std::exchange(told, true))
                        progress.note("finishing this pass; once more stops at once");
                    progress.update(state);
                },
            .keep = [&film, &keeper](const RenderCounters& counters,
                                     double seconds) { keeper.keep(film, counters, seconds); }};
}

void record_warnings(const RenderSummary& summary, const std::string& file,
                     Diagnostics& diagnostics) {
    if (summary.non_finite > 0)
        diagnostics.warn(
            file, "",
            fmt::format("{} samples were not finite and count as black", summary.non_finite));
    if (summary.replaced_pixels > 0)
        diagnostics.warn(file, "",
                         fmt::format("{} pixels were not finite; the denoiser took the mean of "
                                     "their neighbours",
                                     summary.replaced_pixels));
}

SceneFingerprint fingerprint(const Shared& shared) {
    const EnvironmentChoice& environment = *shared.environment;
    return {shared.scene.hash, environment.hash.empty() ? environment.name : environment.hash};
}

// The environment is chosen with the first picture, and its map lent to each in turn.
Result<PictureSetup> set_up(const RenderOptions& options, Shared& shared, Progress& progress,
                            Diagnostics& diagnostics) {
    const Clock::time_point start = Clock::now();
    const bool is_first = !shared.environment;
    if (is_first) {
        HM_TRY_ASSIGN(shared.environment, choose_environment(options, shared.scene));
    }
    HM_TRY_ASSIGN(PictureSetup setup,
                  set_up_picture(options, shared.scene, *shared.environment, diagnostics));
    setup.summary.times.load = std::exchange(shared.load_seconds, 0.0);
    setup.summary.times.flatten = seconds_since(start);
    if (is_first) note_defaults(progress, setup.summary);
    return setup;
}

Keeper make_keeper(const RenderOptions& options, const Shared& shared, const PictureSetup& setup,
                   const Renderer& renderer, Progress& progress) {
    return Keeper(
        options, renderer,
        picture_settings(options, setup.job, setup.aovs.selection, fingerprint(shared)),
        setup.aovs.names,
        [&](const Film& film, const RenderCounters& counters, double seconds,
            const std::string& devices) {
            return picture_metadata(options,
                                    with_samples(setup.summary, film, counters, seconds, devices));
        },
        [&](std::string_view line) { progress.warning(line); });
}

// Where the user has named a GPU, nothing takes over.
template <class T>
Result<T> with_way_out(Result<T> result) {
    if (!result && is_device_trouble(result.error()))
        result.error().message += "; --device cpu draws without it";
    return result;
}

Result<PassResult> draw_samples(Renderer& renderer, const RenderJob& job, Film& film,
                                RenderCounters& counters, Keeper& keeper, Progress& progress) {
    Result<PassResult> passes =
        render_passes(renderer, job, film, counters, keeper.plan(), hooks(film, keeper, progress));
    progress.finish();
    return with_way_out(std::move(passes));
}

// A device that failed in the middle, and what became of the samples that the film had by then.
Result<ExitCode> device_failure(Error error, const Film& film, const Result<void>& written) {
    error.message += written
                         ? fmt::format("; what there was by then, {:.6g} samples/pixel, is written",
                                       film.mean_samples())
                         : "; " + written.error().line();
    return with_way_out(Result<ExitCode>(tl::unexpected(std::move(error))));
}

// One picture.
Result<ExitCode> draw(const RenderOptions& options, Shared& shared, Progress& progress,
                      Diagnostics& diagnostics) {
    HM_TRY_ASSIGN(PictureSetup setup, set_up(options, shared, progress, diagnostics));
    RenderSummary& summary = setup.summary;

    Clock::time_point start = Clock::now();
    HM_TRY_ASSIGN(const std::unique_ptr<Renderer> renderer,
                  with_way_out(shared.device->load(setup.flat)));
    summary.times.prepare = seconds_since(start);
    summary.renderer = renderer->report();

    Film film(options.crop.value_or(PixelRect{0, 0, options.width, options.height}),
              setup.aovs.selection);
    RenderCounters counters;
    Keeper keeper = make_keeper(options, shared, setup, *renderer, progress);
    HM_TRY(keeper.begin(std::exchange(shared.resumed, std::nullopt), film, counters));
    HM_TRY_ASSIGN(const PassResult passes,
                  draw_samples(*renderer, setup.job, film, counters, keeper, progress));
    if (film.most_samples() == 0) {
        progress.note("interrupted before the first sample: nothing is written");
        return ExitCode::interrupted;
    }

    start = Clock::now();
    summary.renderer = renderer->report();
    summary.interrupted = passes.interrupted || passes.failed;
    summary.exposure = options.exposure ? *options.exposure : auto_exposure(film.resolve());
    summary = with_samples(std::move(summary), film, counters, passes.seconds,
                           devices_text(keeper.devices()));
    keeper.keep(film, counters, passes.seconds);
    const Result<void> written =
        write_outputs(options, film, keeper.record(film, counters, passes.seconds),
                      keeper.kept().has_value(), shared.denoiser, summary);
    if (!written && !passes.failed) return tl::unexpected(written.error());
    summary.times.write = seconds_since(start) - summary.times.denoise;

    record_warnings(summary, options.input, diagnostics);
    progress.note(summary_line(summary));
    if (options.json) HM_TRY(print(json_report(options, summary, diagnostics)));
    if (passes.failed) return device_failure(*passes.failed, film, written);
    HM_TRY(keeper.kept());
    shared.environment->map = take_environment(setup.flat);
    return summary.interrupted ? ExitCode::interrupted : ExitCode::ok;
}

}  // namespace

Result<ExitCode> render(const RenderOptions& options) {
    std::optional<tbb::global_control> limit;
    if (options.threads != 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
    Progress progress(options.quiet);
    Diagnostics diagnostics;
    HM_TRY_ASSIGN(std::unique_ptr<Device> device,
                  choose_device(
                      options.device, options.threads,
                      [&](const auto& index) { return open_vulkan_device(index, diagnostics); },
                      [&](std::string_view line) { progress.note(line); }));
    HM_TRY_ASSIGN(std::optional<Checkpoint> resumed,
                  read_checkpoint(options, [&](std::string_view line) { progress.note(line); }));
    std::optional<Denoiser> denoiser;
    if (options.denoise) {
        HM_TRY_ASSIGN(denoiser, Denoiser::open(options.denoise_device, options.threads));
    }
    const Clock::time_point start = Clock::now();
    HM_TRY_ASSIGN(Scene scene, load_gltf(options.scene_file, diagnostics, options.load));
    Shared shared{std::move(device), std::move(denoiser), std::move(scene), seconds_since(start)};
    catch_interrupts();
    ExitCode code = ExitCode::ok;
    FrameRange range = options.frames.value_or(FrameRange{});
    if (resumed && resumed->record.frame) range.first = *resumed->record.frame;
    shared.resumed = std::move(resumed);
    for (std::uint32_t n = range.first; n <= range.last && code == ExitCode::ok; ++n) {
        HM_TRY_ASSIGN(code, draw(options.frames ? frame_options(options, n) : options, shared,
                                 progress, diagnostics));
    }
    for (const Warning& warning : diagnostics.warnings())
        progress.warning(warning.line());
    return code;
}

}  // namespace hm::cli
