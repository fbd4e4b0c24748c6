// The samples of a picture in passes short enough to be watched and stopped.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "app/cli/progress.h"
#include "film/renderer.h"

namespace hm::cli {

struct PassPlan {
    std::uint32_t end = 1;       // index past the last sample; the film knows its first
    std::optional<double> time;  // seconds of rendering in all, those before included
    double seconds_before = 0;   // of rendering that the film has seen already
    // A pass is made to last about this long; the picture does not depend on it.
    double pass_seconds = 0.5;
    std::optional<double> keep_every{};  // seconds
    // Seconds after which the film is brought up to date in any case: more is not lost with a
    // device.
    double sync_every = 60;
};

struct PassHooks {
    // Whether to stop after this pass.
    std::function<bool()> stop;
    // A few times a second, from another thread.
    std::function<void(const ProgressState&)> watch;
    // Every `keep_every` seconds, with the film up to date; rendering waits for it.
    std::function<void(const RenderCounters&, double seconds)> keep{};
};

struct PassResult {
    double seconds = 0;  // those before included
    bool interrupted = false;
    // Why the renderer gave up, where the film has got samples of it all the same. Film and
    // counters are as the film was last brought up to date.
    std::optional<Error> failed{};
};

// Renders into `film`, on top of what it holds, until the samples are there or the time is over, or
// to the end of a pass once `stop` is true; no pass is begun if it is true from the start. Time
// cuts a pass short, though not before each pixel has a sample, and leaves pixels with different
// numbers of samples. So does a pass that takes longer than `keep_every`, but it is finished
// afterwards. Fails where the renderer does before the film has got any sample.
Result<PassResult> render_passes(Renderer& renderer, const RenderJob& job, Film& film,
                                 RenderCounters& counters, const PassPlan& plan,
                                 const PassHooks& hooks);

}  // namespace hm::cli
