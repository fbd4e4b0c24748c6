#include "session/fallback.h"

#include <utility>

#include "base/check.h"

namespace hm {

bool is_device_trouble(const Error& error) {
    return error.kind == ErrorKind::no_device || error.kind == ErrorKind::device_failed;
}

FallbackRenderer::FallbackRenderer(std::unique_ptr<Renderer> first, Replace replace)
    : current_(std::move(first)), replace_(std::move(replace)) {}

Result<void> FallbackRenderer::begin(const RenderJob& job, Film& film) {
    job_ = job;
    film_ = &film;
    counters_ = nullptr;
    cancel_ = nullptr;
    since_sync_.clear();
    film_holds_samples_ = false;
    before_.clear();
    Result<void> begun = current_->begin(job, film);
    return begun ? begun : take_over(begun.error());
}

Result<void> FallbackRenderer::render(std::uint32_t begin, std::uint32_t end,
                                      RenderCounters& counters, const std::atomic<bool>& cancel) {
    HM_CHECK(film_ != nullptr, "samples {} to {} before begin", begin, end);
    const bool is_first = counters_ != &counters;
    counters_ = &counters;
    cancel_ = &cancel;
    if (is_first) remember();
    if (replace_) since_sync_.push_back({begin, end});
    Result<void> drawn = current_->render(begin, end, counters, cancel);
    return drawn ? drawn : take_over(drawn.error());
}

Result<void> FallbackRenderer::sync() {
    Result<void> synced = current_->sync();
    if (!synced) {
        HM_TRY(take_over(synced.error()));
        HM_TRY(current_->sync());
    }
    film_holds_samples_ = film_holds_samples_ || !since_sync_.empty();
    since_sync_.clear();
    remember();
    return {};
}

RendererReport FallbackRenderer::report() const {
    RendererReport report = current_->report();
    if (!before_.empty()) report.device = before_ + ", then " + report.device;
    return report;
}

void FallbackRenderer::remember() {
    if (counters_ == nullptr) return;
    counted_ = {counters_->samples.load(), counters_->rays.load(), counters_->non_finite.load()};
}

// The film is as the last sync left it; everything since then is drawn again. A cancel, for a
// checkpoint or because time is up, ends that early, but not before each pixel has a sample.
Result<void> FallbackRenderer::take_over(const Error& error) {
    if (!replace_ || !is_device_trouble(error)) return tl::unexpected(error);
    if (film_holds_samples_) before_ = current_->report().device;
    HM_TRY_ASSIGN(current_, std::exchange(replace_, nullptr)(error));
    HM_TRY(current_->begin(job_, *film_));
    if (counters_ != nullptr) {
        counters_->samples = counted_.samples;
        counters_->rays = counted_.rays;
        counters_->non_finite = counted_.non_finite;
    }
    bool lacks_first = film_->most_samples() == 0;
    for (Samples s : since_sync_) {
        if (std::exchange(lacks_first, false)) {
            HM_TRY(current_->render(s.begin, s.begin + 1, *counters_, std::atomic<bool>(false)));
            ++s.begin;
        }
        if (cancel_->load()) break;
        HM_TRY(current_->render(s.begin, s.end, *counters_, *cancel_));
    }
    return {};
}

}  // namespace hm
