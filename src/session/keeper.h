// One picture's samples while they are drawn: resumed from a checkpoint, and kept in one.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "session/aovs.h"
#include "session/checkpoint.h"
#include "session/passes.h"

namespace hm {

class Keeper {
  public:
    using Note = std::function<void(std::string_view)>;
    // The picture's metadata for these samples of these devices (devices_text).
    using Describe = std::function<Metadata(const Film&, const RenderCounters&, double seconds,
                                            const std::string& devices)>;

    // `warn` is called for checkpoints that could not be written, which does not end the rendering.
    // The settings are borrowed.
    Keeper(const RenderSettings& settings, const KeepSettings& keep, const Renderer& renderer,
           NamedValues picture, AovSetup aovs, Describe describe, Note warn);

    // Fills the film and the counters from the checkpoint, if there is one, and checks that the
    // next one can be written.
    Result<void> begin(std::optional<Checkpoint> resumed, Film& film, RenderCounters& counters);

    PassPlan plan() const;
    // All devices that drew so far.
    std::vector<std::string> devices() const;

    // Writes the checkpoint, if one is wanted.
    void keep(const Film& film, const RenderCounters& counters, double seconds);
    // Whether the last one was written.
    const Result<void>& kept() const { return kept_; }

    FilmRecord record(const Film& film, const RenderCounters& counters, double seconds) const;

  private:
    const RenderSettings& settings_;
    const KeepSettings& keep_;
    const Renderer& renderer_;
    FilmRecord record_;  // with the facts about earlier samples
    Describe describe_;
    Note warn_;
    Result<void> kept_;
};

}  // namespace hm
