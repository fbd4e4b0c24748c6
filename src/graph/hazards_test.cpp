// Plans of many random graphs are checked against Vulkan's memory model independently: for each
// pair of accesses where one writes, a chain of barriers leads from the first's stages to the
// second's, the first of them makes what was written available, and images are in the layout that
// each access needs.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "graph/plan.h"
#include "graph/usage.h"

namespace hm::graph {
namespace {

using rhi::ImageLayout;
using rhi::Scope;

constexpr std::uint64_t kWrites =
    VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT |
    VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR | VK_ACCESS_2_MEMORY_WRITE_BIT;

struct Random {
    std::mt19937 engine;
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine() % n); }
    bool chance(std::uint32_t one_in) { return below(one_in) == 0; }
};

// Imported and transient images and buffers; passes with all kinds of accesses to up to four of
// them.
Declaration random_graph(Random& random) {
    Declaration graph;
    std::vector<Ref> newest;
    std::vector<bool> written;
    const std::uint32_t resources = 2 + random.below(6);
    for (std::uint32_t i = 0; i < resources; ++i) {
        ResourceDeclaration resource{.name = "r", .is_image = random.chance(2)};
        if (random.chance(2)) {
            resource.before = State{rhi::kEverything, ImageLayout::general};
            resource.after = resource.before;
        } else if (resource.is_image) {
            resource.bytes = 1 + random.below(1000);
        }
        newest.push_back({i, 0});
        written.push_back(resource.imported());
        graph.resources.push_back(std::move(resource));
    }
    const std::uint32_t passes = 1 + random.below(12);
    for (std::uint32_t p = 0; p < passes; ++p) {
        constexpr PassKind kKinds[] = {PassKind::compute, PassKind::trace, PassKind::copy};
        PassDeclaration pass{.name = "p", .kind = kKinds[random.below(3)], .keep = true};
        for (std::uint32_t i = 0; i < resources && pass.accesses.size() < 4; ++i) {
            if (!random.chance(2)) continue;
            AccessKind kind =
                written[i] ? static_cast<AccessKind>(random.below(4)) : AccessKind::write;
            const bool can_sample = graph.resources[i].is_image && pass.kind != PassKind::copy;
            if (kind == AccessKind::sample && !can_sample) kind = AccessKind::read;
            pass.accesses.push_back({newest[i], kind});
            if (!writes(kind)) continue;
            ++newest[i].version;
            written[i] = true;
        }
        graph.passes.push_back(std::move(pass));
    }
    return graph;
}

struct Use {
    std::uint32_t step;  // 0 is before the first one
    AccessKind kind;
    Usage usage;
};

struct Dependency {
    std::uint32_t step;
    PlannedBarrier barrier;
};

class Checker {
  public:
    Checker(const Declaration& graph, const Plan& plan) : graph_(graph) {
        uses_.resize(graph.resources.size());
        barriers_.resize(graph.resources.size());
        const auto end = static_cast<std::uint32_t>(plan.steps.size());
        for (std::uint32_t r = 0; r < graph.resources.size(); ++r)
            if (graph.resources[r].before)
                uses_[r].push_back(outside(0, *graph.resources[r].before));
        for (std::uint32_t step = 0; step < plan.steps.size(); ++step) {
            const PassDeclaration& pass = graph.passes[plan.steps[step].pass];
            for (const Access& access : pass.accesses)
                uses_[access.ref.resource].push_back(
                    {step + 1, access.kind, usage_of(pass.kind, access.kind)});
            for (const PlannedBarrier& barrier : plan.steps[step].barriers)
                barriers_[barrier.resource].push_back({step + 1, barrier});
        }
        for (const PlannedBarrier& barrier : plan.final_barriers)
            barriers_[barrier.resource].push_back({end + 1, barrier});
        for (std::uint32_t r = 0; r < graph.resources.size(); ++r)
            if (graph.resources[r].after && uses_[r].size() > 1)
                uses_[r].push_back(outside(end + 1, *graph.resources[r].after));
    }

    void check() const {
        for (std::uint32_t r = 0; r < uses_.size(); ++r) {
            for (std::size_t i = 0; i < uses_[r].size(); ++i)
                for (std::size_t j = i + 1; j < uses_[r].size(); ++j)
                    if (writes(uses_[r][i].kind) || writes(uses_[r][j].kind))
                        check_pair(r, uses_[r][i], uses_[r][j]);
            if (graph_.resources[r].is_image) check_layouts(r);
        }
    }

  private:
    // Work before and after the graph may have written.
    static Use outside(std::uint32_t step, const State& state) {
        return {step, AccessKind::read_write, {state.scope, state.layout}};
    }

    void check_pair(std::uint32_t r, const Use& first, const Use& second) const {
        std::uint64_t reached = first.usage.scope.stages;
        std::uint64_t to_flush = writes(first.kind) ? first.usage.scope.access & kWrites : 0;
        bool visible = false;
        for (const Dependency& d : barriers_[r]) {
            if (d.step <= first.step || d.step > second.step) continue;
            const PlannedBarrier& b = d.barrier;
            // A barrier that waits for only part of the earlier accesses does not continue the
            // chain.
            if ((b.before.stages & reached) == 0) continue;
            if ((b.before.access & to_flush) == to_flush) to_flush = 0;
            reached |= b.after.stages;
            visible = to_flush == 0 &&
                      (b.after.stages & second.usage.scope.stages) == second.usage.scope.stages &&
                      (b.after.access & second.usage.scope.access) == second.usage.scope.access;
            if (visible) break;
        }
        // A write after a read needs only an execution dependency.
        const bool finished = (reached & second.usage.scope.stages) == second.usage.scope.stages &&
                              std::ranges::any_of(barriers_[r], [&](const Dependency& d) {
                                  return d.step > first.step && d.step <= second.step;
                              });
        EXPECT_TRUE(writes(first.kind) ? visible : finished)
            << "resource " << r << ", steps " << first.step << " and " << second.step;
    }

    void check_layouts(std::uint32_t r) const {
        const ResourceDeclaration& resource = graph_.resources[r];
        ImageLayout layout = resource.imported() ? resource.before->layout : ImageLayout::undefined;
        for (const Use& use : uses_[r]) {
            for (const Dependency& d : barriers_[r]) {
                if (d.step != use.step) continue;
                EXPECT_TRUE(d.barrier.from == layout ||
                            (d.barrier.from == ImageLayout::undefined && !reads(use.kind)))
                    << "resource " << r << ", step " << d.step;
                layout = d.barrier.to;
            }
            EXPECT_EQ(layout, use.usage.layout) << "resource " << r << ", step " << use.step;
        }
    }

    const Declaration& graph_;
    std::vector<std::vector<Use>> uses_;             // by resource
    std::vector<std::vector<Dependency>> barriers_;  // likewise
};

TEST(Hazards, EveryOneIsWaitedFor) {
    Random random{std::mt19937(11)};
    std::size_t barriers = 0, steps = 0;
    for (int round = 0; round < 2000 && !::testing::Test::HasFailure(); ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        const Declaration graph = random_graph(random);
        const Result<Plan> plan = make_plan(graph);
        ASSERT_TRUE(plan.has_value()) << plan.error().line();
        Checker(graph, *plan).check();
        for (const Step& step : plan->steps)
            barriers += step.barriers.size();
        steps += plan->steps.size();
    }
    EXPECT_GT(steps, 5000u);
    EXPECT_GT(barriers, steps);
}

// The check detects a missing barrier.
TEST(Hazards, AMissingBarrierIsSeen) {
    Declaration graph;
    graph.resources.push_back({.name = "image", .is_image = true, .bytes = 1});
    graph.resources.push_back({.name = "out", .before = State{}});
    graph.passes.push_back({"draw", PassKind::compute, {{{0, 0}, AccessKind::write}}, false});
    graph.passes.push_back(
        {"use", PassKind::trace, {{{0, 1}, AccessKind::read}, {{1, 0}, AccessKind::write}}, false});
    Plan plan = *make_plan(graph);
    std::erase_if(plan.steps[1].barriers, [](const PlannedBarrier& b) { return b.resource == 0; });
    EXPECT_NONFATAL_FAILURE(Checker(graph, plan).check(), "resource 0, steps 1 and 2");
}

}  // namespace
}  // namespace hm::graph
