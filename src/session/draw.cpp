#include "session/draw.h"

#include <fmt/format.h>

#include <utility>

#include "base/clock.h"
#include "output/tonemap.h"

namespace hm {
namespace {

// The environment is chosen with the first picture, and its map lent to each in turn.
Result<PictureSetup> set_up(const RenderSettings& settings, Stage& stage, const DrawHooks& hooks,
                            Diagnostics& diagnostics) {
    const Clock::time_point start = Clock::now();
    const bool is_first = !stage.environment;
    if (is_first) {
        HM_TRY_ASSIGN(stage.environment,
                      choose_environment(settings.light, stage.scene, diagnostics));
        const EnvironmentChoice& chosen = *stage.environment;
        stage.fingerprint.environment = chosen.hash.empty() ? chosen.name : chosen.hash;
    }
    HM_TRY_ASSIGN(PictureSetup setup,
                  set_up_picture(settings, stage.scene, *stage.environment, diagnostics));
    setup.summary.times.load = std::exchange(stage.load_seconds, 0.0);
    setup.summary.times.flatten = seconds_since(start);
    if (is_first && hooks.prepared) hooks.prepared(setup.summary);
    return setup;
}

Keeper make_keeper(const RenderSettings& settings, const KeepSettings& keep, const Stage& stage,
                   const PictureSetup& setup, const Renderer& renderer, const DrawHooks& hooks) {
    return Keeper(
        settings, keep, renderer,
        picture_settings(settings, setup.job, setup.aovs.selection, stage.fingerprint), setup.aovs,
        [&](const Film& film, const RenderCounters& counters, double seconds,
            const std::string& devices) {
            const RenderSummary summary =
                with_samples(setup.summary, film, counters, seconds, devices);
            return picture_metadata(settings, summary, hooks.describe(summary));
        },
        hooks.warn);
}

}  // namespace

Result<DrawnPicture> draw_picture(const RenderSettings& settings, const KeepSettings& keep,
                                  Stage& stage, const DrawHooks& hooks, Diagnostics& diagnostics) {
    HM_TRY_ASSIGN(PictureSetup setup, set_up(settings, stage, hooks, diagnostics));
    RenderSummary& summary = setup.summary;

    const Clock::time_point start = Clock::now();
    HM_TRY_ASSIGN(const std::unique_ptr<Renderer> renderer, stage.device.load(setup.flat));
    summary.times.prepare = seconds_since(start);
    summary.renderer = renderer->report();

    Film film(settings.frame.pixels(), setup.aovs.selection);
    RenderCounters counters;
    Keeper keeper = make_keeper(settings, keep, stage, setup, *renderer, hooks);
    HM_TRY(keeper.begin(std::exchange(stage.resumed, std::nullopt), film, counters));
    const PassHooks pass_hooks{.stop = hooks.stop,
                               .watch = hooks.watch,
                               .keep = [&](const RenderCounters& so_far, double seconds) {
                                   keeper.keep(film, so_far, seconds);
                               }};
    HM_TRY_ASSIGN(PassResult passes,
                  render_passes(*renderer, setup.job, film, counters, keeper.plan(), pass_hooks));
    summary.renderer = renderer->report();
    summary.interrupted = passes.interrupted || passes.failed;
    const std::optional<float>& exposure = settings.display.exposure;
    summary.exposure = exposure ? *exposure : auto_exposure(film.resolve());
    summary = with_samples(std::move(summary), film, counters, passes.seconds,
                           devices_text(keeper.devices()));
    if (film.most_samples() > 0) keeper.keep(film, counters, passes.seconds);
    FilmRecord record = keeper.record(film, counters, passes.seconds);
    stage.environment->map = take_environment(setup.flat);
    return DrawnPicture{std::move(film), std::move(record), std::move(summary), keeper.kept(),
                        std::move(passes.failed)};
}

}  // namespace hm
