// Renders the samples of a picture in passes short enough to be watched and stopped.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "film/renderer.h"

namespace hm {

struct ProgressState {
    double fraction = 0;  // of samples or of time, whichever is nearer to its end
    double samples_per_pixel = 0;
    std::uint64_t rays = 0;
    double seconds = 0;  // of rendering
};

struct PassPlan {
    std::uint32_t end = 1;       // one past the last sample; the film knows its first
    std::optional<double> time;  // seconds of rendering in total, earlier ones included
    double seconds_before = 0;   // of rendering that the film already holds
    // A pass is made to last about this long; the picture does not depend on it.
    double pass_seconds = 0.5;
    std::optional<double> keep_every{};  // seconds
    // Seconds after which the film is synchronised in any case: no more is lost with a device.
    double sync_every = 60;
};

struct PassHooks {
    // Whether to stop after this pass.
    std::function<bool()> stop;
    // A few times a second, from another thread. An exception ends the pass and is passed on.
    std::function<void(const ProgressState&)> watch;
    // Every `keep_every` seconds, with the film up to date; rendering waits for it.
    std::function<void(const RenderCounters&, double seconds)> keep{};
};

struct PassResult {
    double seconds = 0;  // earlier ones included
    bool interrupted = false;
    // Why the renderer gave up although the film holds samples of it. Film and counters are those
    // of the last synchronisation.
    std::optional<Error> failed{};
};

// Renders into `film`, on top of what it holds, until all samples are drawn or the time is up, or
// to the end of a pass once `stop` returns true; no pass starts if it is true from the beginning.
// The time limit cuts a pass short, though not before each pixel has a sample, and leaves pixels
// with different numbers of samples. A pass longer than `keep_every` is interrupted too, but
// finished afterwards. Fails if the renderer fails before the film has any sample.
Result<PassResult> render_passes(Renderer& renderer, const RenderJob& job, Film& film,
                                 RenderCounters& counters, const PassPlan& plan,
                                 const PassHooks& hooks);

}  // namespace hm
