#include "session/keeper.h"

#include <utility>

#include "base/files.h"

namespace hm {
namespace {

constexpr double kKeepEvery = 60;  // seconds

}  // namespace

Keeper::Keeper(const RenderSettings& settings, const KeepSettings& keep, const Renderer& renderer,
               NamedValues picture, AovSetup aovs, Describe describe, Note warn)
    : settings_(settings),
      keep_(keep),
      renderer_(renderer),
      describe_(std::move(describe)),
      warn_(std::move(warn)) {
    record_.settings = std::move(picture);
    record_.names = std::move(aovs.names);
    record_.origin = aovs.origin;
    record_.half = settings.layers.half;
    record_.exr = settings.layers.exr;
    record_.frame = settings.animation.frame;
    record_.samples_asked = settings.sampling.samples;
    record_.alpha = settings.path.background == kBackgroundTransparent;
    record_.tone = {settings.display.exposure.value_or(0.0f), settings.display.tone_curve};
    record_.auto_exposure = !settings.display.exposure;
}

Result<void> Keeper::begin(std::optional<Checkpoint> resumed, Film& film,
                           RenderCounters& counters) {
    if (settings_.sampling.range) film.first_sample = settings_.sampling.range->begin;
    if (resumed) {
        HM_TRY(check_resumable(*resumed, keep_, settings_.sampling, record_.settings,
                               renderer_.report().device, film));
        film = std::move(resumed->film);
        record_.seconds = resumed->record.seconds;
        counters.samples = std::uint64_t(film.mean_samples() * double(film.sums.size()) + 0.5);
        counters.rays = resumed->record.rays;
        counters.non_finite = resumed->record.non_finite;
        record_.devices = std::move(resumed->record.devices);
    }
    if (keep_.checkpoint.empty()) return {};
    return check_writable(keep_.checkpoint, stored_bytes(film));
}

std::vector<std::string> Keeper::devices() const {
    std::vector<std::string> devices = record_.devices;
    const std::string current = renderer_.report().device;
    if (devices.empty() || devices.back() != current) devices.push_back(current);
    return devices;
}

PassPlan Keeper::plan() const {
    PassPlan plan{.end = settings_.sampling.end(),
                  .time = settings_.sampling.time,
                  .seconds_before = record_.seconds};
    if (!keep_.checkpoint.empty()) plan.keep_every = keep_.every.value_or(kKeepEvery);
    return plan;
}

void Keeper::keep(const Film& film, const RenderCounters& counters, double seconds) {
    if (keep_.checkpoint.empty()) return;
    kept_ =
        write_checkpoint(keep_.checkpoint, settings_.frame, film, record(film, counters, seconds));
    if (!kept_) warn_(kept_.error().line());
}

FilmRecord Keeper::record(const Film& film, const RenderCounters& counters, double seconds) const {
    FilmRecord record = record_;
    record.devices = devices();
    record.seconds = seconds;
    record.rays = counters.rays.load();
    record.non_finite = counters.non_finite.load();
    record.picture = describe_(film, counters, seconds, devices_text(record.devices));
    return record;
}

}  // namespace hm
