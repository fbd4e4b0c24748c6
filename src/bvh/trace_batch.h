// Traces arrays of rays with each of the traversal's builds that this processor runs. For tests and
// the benchmark; the renderer compiles traversal into its own kernels.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "bvh/view.h"

namespace hm {

// What a batch's any-hit callback accepts on geometries that are not opaque.
inline constexpr std::uint32_t kAcceptAll = 0;
inline constexpr std::uint32_t kAcceptEven = 1;  // primitives of even index

struct TraceBatch {
    const BvhView* view;
    const Ray* rays;
    Hit* hits;  // of a ray that misses: all bytes zero
    std::uint8_t* found;
    std::uint64_t count;
    std::uint32_t accept;        // kAccept*
    std::uint64_t accept_calls;  // out
};

struct TraceVariant {
    std::string_view name;
    void (*closest)(TraceBatch&);
    void (*any)(TraceBatch&);  // leaves hits alone
};

std::span<const TraceVariant> trace_variants();

}  // namespace hm
