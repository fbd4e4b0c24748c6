// Plans are data: order, barriers, lifetimes and places in memory, all without a device.
#include "graph/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "graph/usage.h"

namespace hm::graph {
namespace {

using rhi::ImageLayout;
using rhi::Scope;

// Declares by hand what Graph and Pass declare for others.
class Sketch {
  public:
    Ref image(std::string name, std::uint64_t bytes = 0) {
        return add({.name = std::move(name), .is_image = true, .bytes = bytes});
    }
    Ref buffer(std::string name) { return add({.name = std::move(name)}); }
    Ref imported_image(std::string name, State state) {
        return add({.name = std::move(name), .is_image = true, .before = state, .after = state});
    }
    Ref imported_buffer(std::string name, Scope before = rhi::kEverything) {
        return add({.name = std::move(name), .before = State{before}});
    }
    std::uint32_t pass(std::string name, PassKind kind, std::vector<Access> accesses) {
        declaration.passes.push_back({std::move(name), kind, std::move(accesses), false});
        return static_cast<std::uint32_t>(declaration.passes.size() - 1);
    }
    Plan plan() const {
        Result<Plan> made = make_plan(declaration);
        if (!made) throw std::runtime_error(made.error().line());
        return std::move(*made);
    }
    std::string error() const {
        const Result<Plan> made = make_plan(declaration);
        return made ? "" : made.error().line();
    }

    Declaration declaration;

  private:
    Ref add(ResourceDeclaration resource) {
        declaration.resources.push_back(std::move(resource));
        return {static_cast<std::uint32_t>(declaration.resources.size() - 1), 0};
    }
};

Access read(Ref ref) {
    return {ref, AccessKind::read};
}
Access sample(Ref ref) {
    return {ref, AccessKind::sample};
}
Access write(Ref ref) {
    return {ref, AccessKind::write};
}
Access update(Ref ref) {
    return {ref, AccessKind::read_write};
}
Ref next(Ref ref) {
    return {ref.resource, ref.version + 1};
}

std::vector<std::uint32_t> passes_of(const Plan& plan) {
    std::vector<std::uint32_t> passes;
    for (const Step& step : plan.steps)
        passes.push_back(step.pass);
    return passes;
}

using Passes = std::vector<std::uint32_t>;

const Scope kComputeRead = usage_of(PassKind::compute, AccessKind::read).scope;
const Scope kComputeWrite = usage_of(PassKind::compute, AccessKind::write).scope;
const Scope kComputeUpdate = usage_of(PassKind::compute, AccessKind::read_write).scope;
const Scope kComputeSample = usage_of(PassKind::compute, AccessKind::sample).scope;
const Scope kTraceRead = usage_of(PassKind::trace, AccessKind::read).scope;
const Scope kCopyRead = usage_of(PassKind::copy, AccessKind::read).scope;
const Scope kCopyWrite = usage_of(PassKind::copy, AccessKind::write).scope;

TEST(Usage, FollowsThePassAndTheAccess) {
    EXPECT_EQ(kTraceRead.stages, VK_PIPELINE_STAGE_2_RAY_TRACING_SHADER_BIT_KHR);
    EXPECT_NE(kTraceRead.access & VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR, 0u);
    EXPECT_EQ(kComputeRead.access & VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR, 0u);
    EXPECT_EQ(kComputeWrite.access, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    EXPECT_EQ(kComputeUpdate.access, kComputeRead.access | kComputeWrite.access);
    EXPECT_EQ(usage_of(PassKind::copy, AccessKind::read).layout, ImageLayout::transfer_source);
    EXPECT_EQ(usage_of(PassKind::copy, AccessKind::write).layout, ImageLayout::transfer_target);
    EXPECT_EQ(usage_of(PassKind::trace, AccessKind::sample).layout, ImageLayout::shader_read);
    EXPECT_EQ(usage_of(PassKind::trace, AccessKind::write).layout, ImageLayout::general);
}

// Order.

TEST(Order, FollowsVersionsNotTheList) {
    Sketch s;
    const Ref a = s.buffer("a"), out = s.imported_buffer("out");
    s.pass("last", PassKind::copy, {read(next(a)), write(out)});
    s.pass("first", PassKind::compute, {write(a)});
    EXPECT_EQ(passes_of(s.plan()), (Passes{1, 0}));
}

TEST(Order, ReadersComeBeforeTheNextWriter) {
    Sketch s;
    const Ref a = s.buffer("a"), x = s.imported_buffer("x"), y = s.imported_buffer("y");
    s.pass("write", PassKind::compute, {write(a)});
    s.pass("write again", PassKind::compute, {write(next(a)), write(y)});
    s.pass("read the first", PassKind::compute, {read(next(a)), write(x)});
    EXPECT_EQ(passes_of(s.plan()), (Passes{0, 2, 1}));
}

TEST(Order, FreePassesKeepTheirOrder) {
    Sketch s;
    for (int i = 0; i < 5; ++i)
        s.pass("p", PassKind::compute, {write(s.imported_buffer("out"))});
    EXPECT_EQ(passes_of(s.plan()), (Passes{0, 1, 2, 3, 4}));
}

TEST(Order, CirclesAreNamed) {
    Sketch s;
    const Ref a = s.imported_buffer("a"), b = s.imported_buffer("b");
    s.pass("from b to a", PassKind::compute, {read(next(b)), write(a)});
    s.pass("from a to b", PassKind::compute, {read(next(a)), write(b)});
    s.pass("apart", PassKind::compute, {write(s.imported_buffer("c"))});
    EXPECT_EQ(s.error(), "render graph: passes wait for each other: from b to a, from a to b");
}

TEST(Order, WhatNobodyWritesCannotBeRead) {
    Sketch s;
    const Ref a = s.image("a");
    s.pass("look", PassKind::compute, {read(a), write(s.imported_buffer("out"))});
    EXPECT_EQ(s.error(), "render graph: look: reads version 0 of a, which no pass writes");
}

TEST(Order, UpdatingNothingIsReadingIt) {
    Sketch s;
    s.pass("add", PassKind::compute, {update(s.image("sums")), write(s.imported_buffer("out"))});
    EXPECT_EQ(s.error(), "render graph: add: reads version 0 of sums, which no pass writes");
}

TEST(Order, TwoWritersOfOneVersionAreNamed) {
    Sketch s;
    const Ref a = s.imported_buffer("a");
    s.pass("one", PassKind::compute, {write(a)});
    s.pass("two", PassKind::compute, {write(a)});
    EXPECT_EQ(s.error(), "render graph: two: writes a over the same version as one");
}

TEST(Order, OnePassUsesAResourceOnce) {
    Sketch s;
    const Ref a = s.imported_buffer("a");
    s.pass("both", PassKind::compute, {read(a), write(a)});
    EXPECT_EQ(s.error(), "render graph: both: uses a twice");
}

TEST(Order, UnusedPassesAreCulled) {
    Sketch s;
    const Ref a = s.buffer("a"), b = s.buffer("b"), c = s.buffer("c");
    const Ref out = s.imported_buffer("out");
    s.pass("a", PassKind::compute, {write(a)});
    s.pass("b from a, unused", PassKind::compute, {read(next(a)), write(b)});
    s.pass("c from b, unused", PassKind::compute, {read(next(b)), write(c)});
    s.pass("out from a", PassKind::compute, {read(next(a)), write(out)});
    const Plan plan = s.plan();
    EXPECT_EQ(passes_of(plan), (Passes{0, 3}));
    EXPECT_EQ(plan.culled, (Passes{1, 2}));
    EXPECT_FALSE(plan.lifetimes[b.resource].has_value());

    s.declaration.passes[2].keep = true;
    EXPECT_EQ(passes_of(s.plan()), (Passes{0, 1, 2, 3}));
}

TEST(Order, OverwrittenWorkIsCulled) {
    Sketch s;
    const Ref a = s.buffer("a"), out = s.imported_buffer("out");
    s.pass("lost", PassKind::compute, {write(a)});
    s.pass("kept", PassKind::compute, {write(next(a))});
    s.pass("out", PassKind::compute, {read(next(next(a))), write(out)});
    EXPECT_EQ(passes_of(s.plan()), (Passes{1, 2}));
}

// Barriers.

TEST(Barriers, ReadAfterWriteWaitsForTheWrite) {
    Sketch s;
    const Ref a = s.buffer("a"), out = s.imported_buffer("out", {});
    s.pass("write", PassKind::compute, {write(a)});
    s.pass("read", PassKind::trace, {read(next(a)), write(out)});
    const Plan plan = s.plan();
    ASSERT_EQ(plan.steps[1].barriers.size(), 1u);
    EXPECT_EQ(plan.steps[1].barriers[0], (PlannedBarrier{a.resource, kComputeWrite, kTraceRead}));
}

TEST(Barriers, WriteAfterReadWaitsForReadersToFinishOnly) {
    Sketch s;
    const Ref a = s.imported_buffer("a", {});
    const Ref x = s.imported_buffer("x", {});
    s.pass("read", PassKind::trace, {read(a), write(x)});
    s.pass("overwrite", PassKind::copy, {write(a)});
    const Plan plan = s.plan();
    EXPECT_TRUE(plan.steps[0].barriers.empty());  // nothing wrote either before
    ASSERT_EQ(plan.steps[1].barriers.size(), 1u);
    EXPECT_EQ(plan.steps[1].barriers[0],
              (PlannedBarrier{a.resource, {kTraceRead.stages, 0}, kCopyWrite}));
}

TEST(Barriers, WriteAfterWriteWaitsForTheWrite) {
    Sketch s;
    const Ref a = s.imported_buffer("a", {});
    s.pass("one", PassKind::compute, {write(a)});
    s.pass("two", PassKind::copy, {write(next(a))});
    s.declaration.passes[0].keep = true;
    const Plan plan = s.plan();
    ASSERT_EQ(plan.steps[1].barriers.size(), 1u);
    EXPECT_EQ(plan.steps[1].barriers[0], (PlannedBarrier{a.resource, kComputeWrite, kCopyWrite}));
}

TEST(Barriers, ReadersOfOneVersionShareABarrier) {
    Sketch s;
    const Ref a = s.buffer("a");
    s.pass("write", PassKind::copy, {write(a)});
    s.pass("read", PassKind::compute, {read(next(a)), write(s.imported_buffer("x", {}))});
    s.pass("read too", PassKind::trace, {read(next(a)), write(s.imported_buffer("y", {}))});
    s.pass("read again", PassKind::compute, {read(next(a)), write(s.imported_buffer("z", {}))});
    const Plan plan = s.plan();
    ASSERT_EQ(plan.steps[1].barriers.size(), 1u);
    EXPECT_EQ(plan.steps[1].barriers[0].after, (Scope{kComputeRead.stages | kTraceRead.stages,
                                                      kComputeRead.access | kTraceRead.access}));
    EXPECT_TRUE(plan.steps[2].barriers.empty());
    EXPECT_TRUE(plan.steps[3].barriers.empty());
}

TEST(Barriers, UpdatesInARowWaitForEachOther) {
    Sketch s;
    const Ref sums = s.imported_image("sums", {rhi::kEverything, ImageLayout::general});
    s.pass("add", PassKind::compute, {update(sums)});
    s.pass("add more", PassKind::compute, {update(next(sums))});
    const Plan plan = s.plan();
    EXPECT_EQ(plan.steps[0].barriers,
              (std::vector<PlannedBarrier>{{sums.resource, rhi::kEverything, kComputeUpdate,
                                            ImageLayout::general, ImageLayout::general}}));
    EXPECT_EQ(plan.steps[1].barriers,
              (std::vector<PlannedBarrier>{{sums.resource, kComputeUpdate, kComputeUpdate,
                                            ImageLayout::general, ImageLayout::general}}));
    EXPECT_EQ(plan.final_barriers,
              (std::vector<PlannedBarrier>{{sums.resource, kComputeUpdate, rhi::kEverything,
                                            ImageLayout::general, ImageLayout::general}}));
}

TEST(Barriers, LayoutsChangeWithTheUse) {
    Sketch s;
    const Ref image = s.image("image", 100);
    s.pass("draw", PassKind::compute, {write(image)});
    s.pass("sample", PassKind::compute, {sample(next(image)), write(s.imported_buffer("x", {}))});
    s.pass("copy out", PassKind::copy, {read(next(image)), write(s.imported_buffer("y", {}))});
    const Plan plan = s.plan();
    EXPECT_EQ(plan.steps[0].barriers,
              (std::vector<PlannedBarrier>{{image.resource, rhi::kEverything, kComputeWrite,
                                            ImageLayout::undefined, ImageLayout::general}}));
    EXPECT_EQ(plan.steps[1].barriers,
              (std::vector<PlannedBarrier>{{image.resource, kComputeWrite, kComputeSample,
                                            ImageLayout::general, ImageLayout::shader_read}}));
    // Reads, but in another layout: the samplers must have finished.
    EXPECT_EQ(plan.steps[2].barriers,
              (std::vector<PlannedBarrier>{{image.resource,
                                            {kComputeSample.stages, 0},
                                            kCopyRead,
                                            ImageLayout::shader_read,
                                            ImageLayout::transfer_source}}));
}

TEST(Barriers, AFullWriteForgetsTheLayoutButStillWaits) {
    Sketch s;
    const Ref image = s.imported_image("image", {rhi::kEverything, ImageLayout::shader_read});
    s.pass("draw", PassKind::compute, {write(image)});
    const Plan plan = s.plan();
    EXPECT_EQ(plan.steps[0].barriers,
              (std::vector<PlannedBarrier>{{image.resource, rhi::kEverything, kComputeWrite,
                                            ImageLayout::undefined, ImageLayout::general}}));
    EXPECT_EQ(plan.final_barriers,
              (std::vector<PlannedBarrier>{{image.resource, kComputeWrite, rhi::kEverything,
                                            ImageLayout::general, ImageLayout::shader_read}}));
}

TEST(Barriers, ImportedImagesReturnToTheirLayout) {
    Sketch s;
    const Ref image = s.imported_image("image", {rhi::kEverything, ImageLayout::general});
    s.pass("copy out", PassKind::copy, {read(image), write(s.imported_buffer("x", {}))});
    const Plan plan = s.plan();
    ASSERT_EQ(plan.final_barriers.size(), 1u);
    EXPECT_EQ(plan.final_barriers[0], (PlannedBarrier{image.resource,
                                                      {kCopyRead.stages, 0},
                                                      rhi::kEverything,
                                                      ImageLayout::transfer_source,
                                                      ImageLayout::general}));
}

TEST(Barriers, ReusedMemoryWaitsForItsLastOwner) {
    Sketch s;
    const Ref a = s.image("a", 100), b = s.image("b", 100), c = s.image("c", 100);
    const Ref out = s.imported_buffer("out", {});
    s.pass("a", PassKind::compute, {write(a)});
    s.pass("b", PassKind::compute, {sample(next(a)), write(b)});
    s.pass("c", PassKind::trace, {sample(next(b)), write(c)});
    s.pass("out", PassKind::copy, {read(next(c)), write(out)});
    const Plan plan = s.plan();
    EXPECT_EQ(plan.offsets[a.resource], plan.offsets[c.resource]);
    const auto for_c =
        std::ranges::find(plan.steps[2].barriers, c.resource, &PlannedBarrier::resource);
    ASSERT_NE(for_c, plan.steps[2].barriers.end());
    EXPECT_EQ(for_c->before,
              (Scope{kComputeWrite.stages, kComputeWrite.access | kComputeSample.access}));
    EXPECT_EQ(for_c->from, ImageLayout::undefined);
}

// Lifetimes and places.

TEST(Placement, LivesFromFirstToLastUse) {
    Sketch s;
    const Ref a = s.image("a", 64), b = s.image("b", 64), out = s.imported_buffer("out");
    s.pass("a", PassKind::compute, {write(a)});
    s.pass("b", PassKind::compute, {write(b)});
    s.pass("out", PassKind::compute, {sample(next(b)), sample(next(a)), write(out)});
    const Plan plan = s.plan();
    EXPECT_EQ(plan.lifetimes[a.resource], (Lifetime{0, 2}));
    EXPECT_EQ(plan.lifetimes[b.resource], (Lifetime{1, 2}));
    EXPECT_EQ(plan.lifetimes[out.resource], (Lifetime{2, 2}));
    EXPECT_EQ(plan.heap_bytes, 128u);
    EXPECT_FALSE(plan.offsets[out.resource].has_value());
}

// A chain of eight images, each made from the one before: two places serve in turn.
TEST(Placement, AChainNeedsTwoPlaces) {
    Sketch s;
    Ref last = s.image("first", 1000);
    s.pass("first", PassKind::compute, {write(last)});
    for (int i = 0; i < 7; ++i) {
        const Ref image = s.image("next", 1000);
        s.pass("next", PassKind::compute, {sample(next(last)), write(image)});
        last = image;
    }
    s.pass("out", PassKind::compute, {sample(next(last)), write(s.imported_buffer("out"))});
    EXPECT_EQ(s.plan().heap_bytes, 2000u);
}

TEST(Placement, RespectsAlignment) {
    Sketch s;
    const Ref a = s.image("a", 1000), b = s.image("b", 10), out = s.imported_buffer("out");
    s.declaration.resources[b.resource].alignment = 256;
    s.pass("a", PassKind::compute, {write(a)});
    s.pass("b", PassKind::compute, {write(b)});
    s.pass("out", PassKind::compute, {sample(next(a)), sample(next(b)), write(out)});
    const Plan plan = s.plan();
    EXPECT_EQ(plan.offsets[b.resource], 1024u);
    EXPECT_EQ(plan.heap_bytes, 1034u);
}

// 300 random graphs: images that live at the same time never share a byte, places are aligned, and
// sharing saves something over all.
TEST(Placement, OverlappingLivesNeverShareMemory) {
    std::mt19937 random(7);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    std::uint64_t heap = 0, apart = 0;
    for (int round = 0; round < 300; ++round) {
        Sketch s;
        std::vector<Ref> made;
        const std::uint32_t passes = 3 + below(15);
        for (std::uint32_t p = 0; p < passes; ++p) {
            std::vector<Access> accesses;
            const Ref image = s.image("image", 1 + below(5000));
            s.declaration.resources[image.resource].alignment = 1u << below(9);
            // Up to three of what there is; one image at most once.
            for (std::uint32_t r = made.empty() ? 0 : 1 + below(3); r > 0; --r) {
                const Ref source =
                    made[made.size() - 1 -
                         below(static_cast<std::uint32_t>(std::min<std::size_t>(made.size(), 5)))];
                const bool used =
                    std::ranges::any_of(accesses, [&](const Access& a) { return a.ref == source; });
                if (!used) accesses.push_back(sample(source));
            }
            accesses.push_back(write(image));
            s.pass("pass", PassKind::compute, std::move(accesses));
            made.push_back(next(image));
        }
        s.pass("out", PassKind::compute, {sample(made.back()), write(s.imported_buffer("out"))});
        const Plan plan = s.plan();
        heap += plan.heap_bytes;
        const std::vector<ResourceDeclaration>& r = s.declaration.resources;
        for (std::size_t i = 0; i < r.size(); ++i) {
            if (!plan.offsets[i]) continue;
            apart += r[i].bytes;
            EXPECT_EQ(*plan.offsets[i] % r[i].alignment, 0u);
            EXPECT_LE(*plan.offsets[i] + r[i].bytes, plan.heap_bytes);
            for (std::size_t j = 0; j < i; ++j) {
                if (!plan.offsets[j] || !plan.lifetimes[i]->overlaps(*plan.lifetimes[j])) continue;
                EXPECT_TRUE(*plan.offsets[i] + r[i].bytes <= *plan.offsets[j] ||
                            *plan.offsets[j] + r[j].bytes <= *plan.offsets[i])
                    << "round " << round << ": " << i << " and " << j;
            }
        }
    }
    EXPECT_LT(heap, apart);
}

}  // namespace
}  // namespace hm::graph
