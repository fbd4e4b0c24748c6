// The way a picture travels: load, flatten, put it on a device, render in passes, resolve, write.
#include "app/cli/render.h"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "app/cli/aovs.h"
#include "app/cli/denoise.h"
#include "app/cli/devices.h"
#include "app/cli/frames.h"
#include "app/cli/interrupt.h"
#include "app/cli/keeper.h"
#include "app/cli/output.h"
#include "app/cli/passes.h"
#include "app/cli/pictures.h"
#include "app/cli/report.h"
#include "app/cli/setup.h"
#include "app/cli/vulkan_devices.h"
#include "film/tonemap.h"
#include "film/variance.h"
#include "film/write.h"
#include "gltf/load.h"

namespace hm::cli {
namespace {

// Of a range of the samples, .exr files are parts. All are tried, and the first error is returned.
Result<void> write_all(const RenderOptions& options, const Film& film, const FilmRecord& record,
                       const std::optional<Denoiser>& denoiser, RenderSummary& summary) {
    std::vector<std::filesystem::path> pictures;
    Result<void> outcome;
    for (const std::filesystem::path& path : options.outputs) {
        const bool is_part = options.keep.samples && picture_kind(path) == PictureKind::exr;
        if (!is_part) pictures.push_back(path);
        Result<void> written = is_part ? write_part(path, options, film, record) : Result<void>();
        if (!written && outcome) outcome = std::move(written);
    }
    const Result<PicturesReport> written = write_pictures(
        pictures, film, options.width, options.height, record, denoiser ? &*denoiser : nullptr);
    if (!written) return outcome ? tl::unexpected(written.error()) : outcome;
    if (denoiser) summary.denoiser = denoiser->description();
    summary.times.denoise = written->denoise_seconds;
    summary.replaced_pixels = written->replaced_pixels;
    return outcome;
}

// What could not be written is not lost where it is in the checkpoint.
Result<void> say_where_kept(Result<void> written, const RenderOptions& options,
                            const Keeper& keeper) {
    if (!written && !options.keep.checkpoint.empty() && keeper.kept())
        written.error().message +=
            fmt::format("; the samples are kept in {}, --resume writes again",
                        options.keep.checkpoint.string());
    return written;
}

void fill_results(RenderSummary& summary, const Film& film, const RenderCounters& counters,
                  double seconds) {
    summary.times.render = seconds;
    summary.samples = counters.samples.load();
    summary.rays = counters.rays.load();
    summary.non_finite = counters.non_finite.load();
    summary.samples_per_pixel = film.mean_samples();
    summary.removed_luminance = film.removed_luminance();
    summary.mean_luminance = film.mean_luminance();
    summary.estimated_error = estimated_error(film);
}

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

Result<RenderJob> make_job(const RenderOptions& options, const Scene& scene, const FlatScene& flat,
                           const CameraData& camera, const std::optional<PoseRecord>& next_pose) {
    RenderJob job{camera, make_params(options, flat), make_filter_table(options.filter)};
    if (!next_pose) return job;
    const float aspect = float(options.width) / float(options.height);
    HM_TRY_ASSIGN(const CameraChoice next,
                  choose_camera(options.view, scene, next_pose->world, flat.bounds, aspect));
    job.next_camera = next.data;
    return job;
}

// One picture. It borrows the environment's tables.
Result<ExitCode> draw(const RenderOptions& options, Shared& shared, Progress& progress,
                      Diagnostics& diagnostics) {
    RenderSummary summary;
    summary.times.load = std::exchange(shared.load_seconds, 0.0);

    Clock::time_point start = Clock::now();
    HM_TRY_ASSIGN(const auto pose, choose_pose(options, shared.scene, diagnostics));
    HM_TRY_ASSIGN(const auto next_pose, record_next_pose(options, shared.scene, pose));
    if (pose) HM_TRY(pose_scene(shared.scene, pose));
    const bool is_first = !shared.environment;
    if (is_first) {
        HM_TRY_ASSIGN(shared.environment, choose_environment(options, shared.scene));
    }
    summary.environment = shared.environment->name;
    FlatScene flat = flatten(shared.scene, std::move(shared.environment->map),
                             LightChoice{.punctual = options.punctual}, diagnostics);
    const float aspect = float(options.width) / float(options.height);
    HM_TRY_ASSIGN(const CameraChoice camera,
                  choose_camera(options.view, shared.scene, flat.bounds, aspect));
    const AovSetup aovs = prepare_aovs(options, shared.scene, flat, next_pose);
    summary.camera = camera.name;
    summary.view = view_flags(camera.data);
    summary.scene = scene_stats(shared.scene, flat);
    summary.scene_hash = shared.scene.hash;
    summary.times.flatten = seconds_since(start);
    if (is_first) note_defaults(progress, summary);

    start = Clock::now();
    HM_TRY_ASSIGN(const std::unique_ptr<Renderer> renderer, shared.device->load(flat));
    summary.times.prepare = seconds_since(start);

    Film film(options.crop.value_or(PixelRect{0, 0, options.width, options.height}),
              aovs.selection);
    RenderCounters counters;
    HM_TRY_ASSIGN(const RenderJob job,
                  make_job(options, shared.scene, flat, camera.data, next_pose));
    summary.renderer = renderer->report();
    Keeper keeper(
        options, *renderer, picture_settings(options, job, film.selection, fingerprint(shared)),
        aovs.names,
        [&](const Film& so_far, const RenderCounters& counted, double seconds) {
            RenderSummary now = summary;
            now.renderer.device = devices_text(keeper.devices());
            fill_results(now, so_far, counted, seconds);
            return picture_metadata(options, now);
        },
        [&](std::string_view line) { progress.warning(line); });
    HM_TRY(keeper.begin(std::exchange(shared.resumed, std::nullopt), film, counters));
    HM_TRY_ASSIGN(const PassResult passes,
                  render_passes(*renderer, job, film, counters, keeper.plan(),
                                hooks(film, keeper, progress)));
    progress.finish();
    summary.renderer = renderer->report();
    summary.renderer.device = devices_text(keeper.devices());
    summary.interrupted = passes.interrupted;
    fill_results(summary, film, counters, passes.seconds);
    if (film.most_samples() == 0) {
        progress.note("interrupted before the first sample: nothing is written");
        return ExitCode::interrupted;
    }

    start = Clock::now();
    summary.exposure = options.exposure ? *options.exposure : auto_exposure(film.resolve());
    keeper.keep(film, counters, passes.seconds);
    HM_TRY(say_where_kept(write_all(options, film, keeper.record(film, counters, passes.seconds),
                                    shared.denoiser, summary),
                          options, keeper));
    summary.times.write = seconds_since(start) - summary.times.denoise;

    record_warnings(summary, options.input, diagnostics);
    progress.note(summary_line(summary));
    if (options.json) HM_TRY(print(json_report(options, summary, diagnostics)));
    shared.environment->map = std::move(flat.environment);
    HM_TRY(keeper.kept());
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
