// What measure_tracing (gpu/bench.h) finds; plain numbers.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace hm {

// Of one sample of each pixel of a picture. Times are the device's own, the median of the repeats.
struct TraceRates {
    std::uint64_t closest_rays = 0;
    std::uint64_t shadow_rays = 0;
    double path_ms = 0;  // tracing the paths as a picture does
    // traceRay of the same rays, recorded before, with a hit shader that does nothing and all
    // geometry opaque: by one invocation per ray, and by one per pixel, which loops over its rays
    // as the path tracer does.
    double bare_ms = 0;
    double bare_closest_ms = 0;  // one invocation per ray, of that kind alone
    double bare_shadow_ms = 0;
    double bare_loop_ms = 0;
    // Milliseconds of one sample of each pixel when several are rendered, by way of launching.
    std::uint32_t several = 0;
    std::vector<std::pair<std::string, double>> ways;

    std::uint64_t rays() const { return closest_rays + shadow_rays; }
};

}  // namespace hm
