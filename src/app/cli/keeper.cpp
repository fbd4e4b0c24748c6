#include "app/cli/keeper.h"

#include <utility>

#include "base/files.h"

namespace hm::cli {
namespace {

constexpr double kKeepEvery = 60;  // seconds

}  // namespace

Keeper::Keeper(const RenderOptions& options, const Renderer& renderer, Settings settings,
               SurfaceNames names, Describe describe, Note warn)
    : options_(options),
      renderer_(renderer),
      describe_(std::move(describe)),
      warn_(std::move(warn)) {
    record_.settings = std::move(settings);
    record_.names = std::move(names);
    record_.half = options.layers.half;
    record_.exr = options.layers.exr;
    record_.frame = options.frame;
    record_.samples_asked = options.samples;
    record_.alpha = options.background == kBackgroundTransparent;
    record_.tone = {options.exposure.value_or(0.0f), options.tone_curve};
    record_.auto_exposure = !options.exposure;
}

Result<void> Keeper::begin(std::optional<Checkpoint> resumed, Film& film,
                           RenderCounters& counters) {
    if (options_.keep.samples) film.first_sample = options_.keep.samples->begin;
    if (resumed) {
        HM_TRY(
            check_resumable(*resumed, options_, record_.settings, renderer_.report().device, film));
        film = std::move(resumed->film);
        record_.seconds = resumed->record.seconds;
        counters.samples = std::uint64_t(film.mean_samples() * double(film.sums.size()) + 0.5);
        counters.rays = resumed->record.rays;
        counters.non_finite = resumed->record.non_finite;
        record_.devices = std::move(resumed->record.devices);
    }
    if (options_.keep.checkpoint.empty()) return {};
    return check_writable(options_.keep.checkpoint, stored_bytes(film));
}

std::vector<std::string> Keeper::devices() const {
    std::vector<std::string> devices = record_.devices;
    const std::string current = renderer_.report().device;
    if (devices.empty() || devices.back() != current) devices.push_back(current);
    return devices;
}

PassPlan Keeper::plan() const {
    PassPlan plan{
        .end = options_.sample_end(), .time = options_.time, .seconds_before = record_.seconds};
    if (!options_.keep.checkpoint.empty())
        plan.keep_every = options_.keep.every.value_or(kKeepEvery);
    return plan;
}

void Keeper::keep(const Film& film, const RenderCounters& counters, double seconds) {
    if (options_.keep.checkpoint.empty()) return;
    kept_ = write_checkpoint(options_, film, record(film, counters, seconds));
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

}  // namespace hm::cli
