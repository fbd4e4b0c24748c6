// The samples of a picture in passes short enough to be watched and stopped.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "app/cli/progress.h"
#include "film/renderer.h"

namespace hm::cli {

struct PassPlan {
    std::uint32_t samples = 1;
    std::optional<double> time;  // seconds
    // A pass is made to last about this long; the picture does not depend on it.
    double pass_seconds = 0.5;
};

struct PassResult {
    double seconds = 0;
    bool interrupted = false;
};

// Renders into `film` until the samples are there, the time is over or `stop` returns true. The
// first pass, one sample, is cut short by `stop` alone. Passes cut short leave pixels with
// different numbers of samples. `watch` is called a few times a second, by one thread at a time.
Result<PassResult> render_passes(Renderer& renderer, const RenderJob& job, Film& film,
                                 RenderCounters& counters, const PassPlan& plan,
                                 const std::function<bool()>& stop,
                                 const std::function<void(const ProgressState&)>& watch);

}  // namespace hm::cli
