// Whether several samples of a picture are rendered by one launch that loops over them or by one
// launch each. In a loop the paths of one warp end at different times; between launches a device
// drains. Which costs more depends on scene and device (docs/performance.md), so both are timed
// while a picture is rendered. Plain data; no bit of a picture depends on it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace hm {

enum class Launches : std::uint8_t { loop, one_per_sample };

class LaunchChoice {
  public:
    // For the next submission. Until the choice is made, the two alternate, and each comes first in
    // every other pair, so that a card's rising clock favours neither.
    Launches next();
    // For submissions in the order of next(): milliseconds of one sample of each pixel, or nothing
    // if the submission was too short to measure.
    void learn(Launches launches, std::optional<double> milliseconds);
    // The one that was faster in most pairs.
    std::optional<Launches> decided() const { return decided_; }

  private:
    struct Timing {
        Launches launches;
        double milliseconds;
    };
    std::uint32_t turn_ = 0;
    std::optional<Timing> unpaired_;
    std::array<std::uint32_t, 2> wins_{};
    std::optional<Launches> decided_;
};

}  // namespace hm
