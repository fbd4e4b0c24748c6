// Traces arrays of rays with each variant of the traversal that this CPU supports. For tests and
// the benchmark; the renderer compiles traversal into its own kernels.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "bvh/view.h"

namespace hm {

// Which hits on non-opaque geometries a batch's any-hit callback accepts.
inline constexpr std::uint32_t kAcceptAll = 0;
inline constexpr std::uint32_t kAcceptEven = 1;  // primitives with an even index

struct TraceBatch {
    const BvhView* view;
    const Ray* rays;
    Hit* hits;  // all bytes zero for rays that miss
    std::uint8_t* found;
    std::uint64_t count;
    std::uint32_t accept;        // kAccept*
    std::uint64_t accept_calls;  // output
};

struct TraceVariant {
    std::string_view name;
    void (*closest)(TraceBatch&);
    void (*any)(TraceBatch&);  // does not write hits
};

std::span<const TraceVariant> trace_variants();

}  // namespace hm
