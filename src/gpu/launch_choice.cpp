#include "gpu/launch_choice.h"

namespace hm {

// The best of five pairs, so that one or two disturbed timings do not decide.
constexpr std::uint32_t kWinsNeeded = 3;

Launches LaunchChoice::next() {
    if (decided_) return *decided_;
    const std::uint32_t turn = turn_++;
    return (turn + 1) / 2 % 2 == 0 ? Launches::loop : Launches::one_per_sample;
}

void LaunchChoice::learn(Launches launches, std::optional<double> milliseconds) {
    const std::optional<Timing> before = unpaired_;
    unpaired_.reset();
    if (decided_ || !milliseconds) return;
    if (!before || before->launches == launches) {
        unpaired_ = {launches, *milliseconds};
        return;
    }
    const Launches faster = *milliseconds < before->milliseconds ? launches : before->launches;
    if (++wins_[std::size_t(faster)] == kWinsNeeded) decided_ = faster;
}

}  // namespace hm
