// `himalaya render`: loads the scene, draws one picture or a sequence of them, writes the files and
// reports.
#include "app/cli/render.h"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "app/cli/drivers.h"
#include "app/cli/frames.h"
#include "app/cli/hints.h"
#include "app/cli/interrupt.h"
#include "app/cli/output.h"
#include "app/cli/picture_hints.h"
#include "app/cli/progress.h"
#include "app/cli/report.h"
#include "base/clock.h"
#include "gltf/load.h"
#include "session/draw.h"
#include "session/fallback.h"
#include "session/outputs.h"
#include "session/vulkan_devices.h"

namespace hm::cli {
namespace {

void note_defaults(Progress& progress, const RenderSettings& settings,
                   const RenderSummary& summary) {
    if (summary.environment == "default")
        progress.note(
            "the scene has no punctual light: using the default environment (--env none "
            "for black)");
    if (summary.camera == "framing" && settings.view.camera != kNoCamera)
        progress.note("the file has no usable camera: framing the whole scene (see --eye)");
    if (summary.mixes_light_units)
        progress.note(
            "Blender's exporter multiplies lamps by 683 and emission not; --light-units blender "
            "draws them as Blender does");
}

DrawHooks hooks(const RenderOptions& options, Progress& progress) {
    return {
        .stop = interrupted,
        .watch =
            [&progress, noted = false](const ProgressState& state) mutable {
                if (interrupted() && !std::exchange(noted, true))
                    progress.note("finishing this pass; interrupt again to stop immediately");
                progress.update(state);
            },
        .warn = [&progress](std::string_view line) { progress.warning(line); },
        .prepared =
            [&](const RenderSummary& summary) {
                note_defaults(progress, options.settings, summary);
            },
        .describe =
            [&options](const RenderSummary& summary) { return metadata_texts(options, summary); }};
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

// If the user has chosen a GPU, nothing takes over.
template <class T>
Result<T> with_cpu_hint(Result<T> result) {
    if (!result && is_device_trouble(result.error()))
        result.error().message += "; --device cpu renders without it";
    return result;
}

// A device that failed in the middle, and what became of the samples that the film had by then.
Result<ExitCode> device_failure(Error error, const Film& film, const Result<void>& written) {
    error.message += written
                         ? fmt::format("; what there was by then, {:.6g} samples/pixel, is written",
                                       film.mean_samples())
                         : "; " + written.error().line();
    return with_cpu_hint(Result<ExitCode>(tl::unexpected(std::move(error))));
}

// The error says where the samples are, if the checkpoint has them.
Result<void> write_files(const RenderOptions& options, DrawnPicture& drawn,
                         const Denoiser* denoiser) {
    Result<void> written = write_outputs(options.outputs, options.settings, drawn.film,
                                         drawn.record, denoiser, drawn.summary);
    const std::filesystem::path& checkpoint = options.keep.checkpoint;
    if (!written && !checkpoint.empty() && drawn.kept)
        written.error().message +=
            fmt::format("; the samples are kept in {}, --resume writes again", checkpoint.string());
    return written;
}

// One picture.
Result<ExitCode> draw(const RenderOptions& options, Stage& stage, const Denoiser* denoiser,
                      Progress& progress, Diagnostics& diagnostics) {
    Result<DrawnPicture> result =
        draw_picture(options.settings, options.keep, stage, hooks(options, progress), diagnostics);
    progress.finish();
    HM_TRY_ASSIGN(DrawnPicture drawn, with_cpu_hint(std::move(result)));
    if (drawn.film.most_samples() == 0) {
        progress.note("interrupted before the first sample: nothing is written");
        return ExitCode::interrupted;
    }

    const Clock::time_point start = Clock::now();
    RenderSummary& summary = drawn.summary;
    const Result<void> written = write_files(options, drawn, denoiser);
    if (!written && !drawn.failed) return tl::unexpected(written.error());
    summary.times.write = seconds_since(start) - summary.times.denoise;

    record_warnings(summary, options.input, diagnostics);
    progress.note(summary_line(summary));
    if (const std::optional<std::string> hint = picture_hint(options, summary, drawn.film))
        progress.note(*hint);
    if (options.json) HM_TRY(print(json_report(options, summary, diagnostics)));
    if (drawn.failed) return device_failure(*drawn.failed, drawn.film, written);
    HM_TRY(drawn.kept);
    return summary.interrupted ? ExitCode::interrupted : ExitCode::ok;
}

Result<std::unique_ptr<RenderDevice>> open_device(const RenderOptions& options, Progress& progress,
                                                  Diagnostics& diagnostics) {
    if (options.device.kind != DeviceChoice::Kind::cpu) add_hidden_drivers();
    Result<std::unique_ptr<RenderDevice>> device = choose_device(
        options.device, options.threads,
        [&](const auto& index) { return open_vulkan_device(index, diagnostics); },
        [&](std::string_view line) { progress.note(line); });
    if (!device && options.device.kind == DeviceChoice::Kind::vulkan)
        device.error().message += "; `himalaya doctor` explains what to do";
    return device;
}

// A checkpoint is of a single picture, or of a frame of this sequence.
Result<void> check_frame(const FilmRecord& record, const RenderOptions& options) {
    const auto refuse = [&options](std::string message) {
        return fail(ErrorKind::invalid_argument, options.keep.resume.string(), "",
                    std::move(message));
    };
    if (record.frame && !options.frames)
        return refuse(fmt::format("is of frame {} of a sequence; give --frames", *record.frame));
    if (!options.frames) return {};
    if (!record.frame) return refuse("is of a single picture, not of a sequence");
    if (*record.frame < options.frames->first || *record.frame > options.frames->last)
        return refuse(fmt::format("is of frame {}, which --frames {}:{} does not have",
                                  *record.frame, options.frames->first, options.frames->last));
    const std::uint32_t samples = options.settings.sampling.samples;
    if (record.samples_asked != samples)
        return refuse(
            fmt::format("is of a sequence with --spp {} (now {})", record.samples_asked, samples));
    return {};
}

}  // namespace

Result<ExitCode> render(const RenderOptions& options) {
    std::optional<tbb::global_control> limit;
    if (options.threads != 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
    Progress progress(options.quiet);
    Diagnostics diagnostics;
    HM_TRY_ASSIGN(const std::unique_ptr<RenderDevice> device,
                  open_device(options, progress, diagnostics));
    HM_TRY_ASSIGN(
        std::optional<Checkpoint> resumed,
        read_checkpoint(options.keep, [&](std::string_view line) { progress.note(line); }));
    if (resumed) HM_TRY(check_frame(resumed->record, options));
    std::optional<Denoiser> denoiser;
    if (options.settings.denoise.enabled) {
        HM_TRY_ASSIGN(denoiser, Denoiser::open(options.settings.denoise.device, options.threads));
    }
    const Clock::time_point start = Clock::now();
    HM_TRY_ASSIGN(Scene scene, load_gltf(options.scene_file, diagnostics, options.load));
    Stage stage{*device,
                scene,
                {scene.hash, options.load.scene, options.load.variant},
                seconds_since(start)};
    catch_interrupts();
    ExitCode code = ExitCode::ok;
    FrameRange range = options.frames.value_or(FrameRange{});
    if (resumed && resumed->record.frame) range.first = *resumed->record.frame;
    stage.resumed = std::move(resumed);
    for (std::uint32_t n = range.first; n <= range.last && code == ExitCode::ok; ++n) {
        HM_TRY_ASSIGN(code, draw(options.frames ? frame_options(options, n) : options, stage,
                                 denoiser ? &*denoiser : nullptr, progress, diagnostics));
    }
    for (const Warning& warning : diagnostics.warnings())
        progress.warning(warning.line());
    return code;
}

}  // namespace hm::cli
