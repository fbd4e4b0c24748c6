// Places transient images in the heap: largest first, each at the lowest offset that is free for
// its whole lifetime.
#include <algorithm>
#include <numeric>

#include "base/check.h"
#include "graph/plan.h"

namespace hm::graph {

namespace {

std::vector<std::optional<Lifetime>> find_lifetimes(const Declaration& declaration,
                                                    const std::vector<Step>& steps) {
    std::vector<std::optional<Lifetime>> lifetimes(declaration.resources.size());
    for (std::uint32_t i = 0; i < steps.size(); ++i) {
        for (const Access& access : declaration.passes[steps[i].pass].accesses) {
            std::optional<Lifetime>& lifetime = lifetimes[access.ref.resource];
            if (!lifetime) lifetime = Lifetime{i, i};
            lifetime->last = i;
        }
    }
    return lifetimes;
}

struct Range {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
};

// `taken` is sorted by offset.
std::uint64_t lowest_free(const std::vector<Range>& taken, std::uint64_t bytes,
                          std::uint64_t alignment) {
    std::uint64_t offset = 0;
    for (const Range& range : taken) {
        if (offset + bytes <= range.begin) break;
        offset = std::max(offset, (range.end + alignment - 1) / alignment * alignment);
    }
    return offset;
}

}  // namespace

void place_transients(const Declaration& declaration, Plan& plan) {
    plan.lifetimes = find_lifetimes(declaration, plan.steps);
    plan.offsets.assign(declaration.resources.size(), std::nullopt);
    plan.heap_bytes = 0;

    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < declaration.resources.size(); ++i)
        if (declaration.resources[i].bytes > 0 && plan.lifetimes[i]) order.push_back(i);
    std::ranges::stable_sort(order, std::greater{}, [&](std::uint32_t resource) {
        return declaration.resources[resource].bytes;
    });
    for (const std::uint32_t resource : order) {
        const ResourceDeclaration& placed = declaration.resources[resource];
        HM_CHECK(placed.alignment > 0 && !placed.imported(), "resource {}", placed.name);
        std::vector<Range> taken;
        for (const std::uint32_t other : order)
            if (plan.offsets[other] && plan.lifetimes[other]->overlaps(*plan.lifetimes[resource]))
                taken.push_back({*plan.offsets[other],
                                 *plan.offsets[other] + declaration.resources[other].bytes});
        std::ranges::sort(taken, {}, &Range::begin);
        const std::uint64_t offset = lowest_free(taken, placed.bytes, placed.alignment);
        plan.offsets[resource] = offset;
        plan.heap_bytes = std::max(plan.heap_bytes, offset + placed.bytes);
    }
}

}  // namespace hm::graph
