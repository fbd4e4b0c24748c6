// One picture's samples while they are drawn: taken up from a checkpoint, kept in it, and counted.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "app/cli/checkpoint.h"
#include "app/cli/passes.h"

namespace hm::cli {

class Keeper {
  public:
    using Note = std::function<void(std::string_view)>;
    // The picture's metadata as they are with these samples of these devices (devices_text).
    using Describe = std::function<Metadata(const Film&, const RenderCounters&, double seconds,
                                            const std::string& devices)>;

    // `warn` hears of checkpoints that could not be written, which ends no rendering.
    Keeper(const RenderOptions& options, const Renderer& renderer, Settings settings,
           SurfaceNames names, Describe describe, Note warn);

    // Fills the film and the counters from the checkpoint, if there is one, and sees whether the
    // next one can be written.
    Result<void> begin(std::optional<Checkpoint> resumed, Film& film, RenderCounters& counters);

    PassPlan plan() const;
    // All that drew so far.
    std::vector<std::string> devices() const;

    // Nothing where no checkpoint is asked for.
    void keep(const Film& film, const RenderCounters& counters, double seconds);
    // Whether the last one was written.
    const Result<void>& kept() const { return kept_; }

    FilmRecord record(const Film& film, const RenderCounters& counters, double seconds) const;

  private:
    const RenderOptions& options_;
    const Renderer& renderer_;
    FilmRecord record_;  // with what is true of the samples before
    Describe describe_;
    Note warn_;
    Result<void> kept_;
};

}  // namespace hm::cli
