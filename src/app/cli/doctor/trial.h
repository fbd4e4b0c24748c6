// Tests drivers: renders a small picture on every device and compares it with the CPU's.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "film/film.h"
#include "session/devices.h"

namespace hm::cli {

// The difference of two pictures with the same samples. Both use the same random numbers, but
// rounding differs, so a path near the edge of a triangle may diverge: a few pixels differ a lot,
// but the mean hardly changes.
struct Parity {
    double mean_difference = 0;  // of luminance, relative to the reference's mean
    double standard_error = 0;   // of that, from the pixels' paired differences
    double share_close = 0;      // of pixels whose channels are all within 1 %

    // The mean within 1e-3 or 4 standard errors, and 99 % of pixels close.
    bool holds() const;
};
Parity compare_films(const Film& film, const Film& reference);

struct Trial {
    std::string device;   // "vulkan:0 NVIDIA H200"
    std::string trouble;  // why there is no picture
    double prepare_seconds = 0, render_seconds = 0;
    std::uint64_t rays = 0;
    std::optional<Parity> parity;  // with the first trial, the CPU's

    bool holds() const { return trouble.empty() && (!parity || parity->holds()); }
};

struct Contender {
    std::string name;
    std::function<Result<std::unique_ptr<RenderDevice>>()> open;
};

inline constexpr std::uint32_t kTrialSize = 64, kTrialSamples = 16;

// Renders demo:cornell on each; the first is the reference. `begun` is called with the name before
// each. Fails if the scene cannot be loaded.
Result<std::vector<Trial>> run_trials(const std::vector<Contender>& contenders,
                                      const std::function<void(std::string_view)>& begun);

}  // namespace hm::cli
