// The plan of a frame: which passes run, their order, the barriers between them, and the memory
// offsets of transient images. Computed from a Declaration without any device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "graph/declaration.h"

namespace hm::graph {

// A barrier before a pass, for one resource. Layouts are ignored for buffers.
struct PlannedBarrier {
    std::uint32_t resource = 0;
    rhi::Scope before;
    rhi::Scope after;
    rhi::ImageLayout from = rhi::ImageLayout::undefined;
    rhi::ImageLayout to = rhi::ImageLayout::undefined;

    bool operator==(const PlannedBarrier&) const = default;
};

struct Step {
    std::uint32_t pass = 0;  // index into Declaration::passes
    std::vector<PlannedBarrier> barriers;
};

// Indices into Plan::steps, both inclusive.
struct Lifetime {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    bool overlaps(const Lifetime& other) const {
        return first <= other.last && other.first <= last;
    }
    bool operator==(const Lifetime&) const = default;
};

struct Plan {
    std::vector<Step> steps;
    std::vector<PlannedBarrier> final_barriers;
    std::vector<std::uint32_t> culled;  // passes, in declared order
    // By resource; empty for one that no step accesses.
    std::vector<std::optional<Lifetime>> lifetimes;
    // Byte offsets in the heap, by resource; empty for one outside the heap.
    std::vector<std::optional<std::uint64_t>> offsets;
    std::uint64_t heap_bytes = 0;
};

// Fails, naming passes and resources, if passes depend on each other in a cycle, if a version is
// read that no pass writes, or is written twice.
Result<Plan> make_plan(const Declaration& declaration);

// The parts of make_plan, in order.
//
// Returns the passes that run, in order: a version's writer before its readers, and these before
// the writer of the next version. Passes that are ready at the same time keep the declared order.
Result<std::vector<std::uint32_t>> order_passes(const Declaration& declaration);
// Fills lifetimes, offsets and heap_bytes from the steps' passes. Images whose lifetimes overlap
// never overlap in the heap.
void place_transients(const Declaration& declaration, Plan& plan);
// Fills barriers from steps and offsets. Readers of the same version in the same layout share a
// barrier; a pass whose accesses are already synchronised gets none.
void plan_barriers(const Declaration& declaration, Plan& plan);

}  // namespace hm::graph
