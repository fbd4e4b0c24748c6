// A small picture on every device, compared with the CPU's, as a test of drivers.
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

// How much two pictures of the same samples differ. Both use the same random numbers, but round
// differently, so that a path near the edge of a triangle may branch off: a few pixels differ much,
// and the mean hardly.
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

// Draws demo:cornell on each; the first is the reference. `begun` is called with its name before
// each. Fails if the scene can't be loaded.
Result<std::vector<Trial>> run_trials(const std::vector<Contender>& contenders,
                                      const std::function<void(std::string_view)>& begun);

}  // namespace hm::cli
