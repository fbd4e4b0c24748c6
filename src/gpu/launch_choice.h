// Whether several samples of a picture are drawn by one launch that loops over them or by a launch
// of each. In a loop the paths of one warp end at different times; between launches a device runs
// empty. What costs more depends on scene and device (docs/performance.md), so both are timed while
// a picture is drawn. Plain data; no bit of a picture depends on it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace hm {

enum class Launches : std::uint8_t { loop, one_per_sample };

class LaunchChoice {
  public:
    // For the next submission. Until it is decided the two take turns, and each comes first in
    // every other pair: a card's clock, which rises meanwhile, favours neither.
    Launches next();
    // Of submissions in the order of next(): milliseconds of one sample of each pixel, or nothing
    // where the submission was too short to tell.
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
