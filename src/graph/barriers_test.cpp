// What each access means, and the barriers between passes.
#include <gtest/gtest.h>

#include <algorithm>

#include "graph/plan.h"
#include "graph/sketch.h"
#include "graph/usage.h"

namespace hm::graph {
namespace {

using rhi::ImageLayout;
using rhi::Scope;
using test::next;
using test::read;
using test::sample;
using test::Sketch;
using test::update;
using test::write;

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
    EXPECT_TRUE(plan.steps[0].barriers.empty());  // neither was written before
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
    // A read, but in another layout: the earlier sampled reads must have finished.
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

}  // namespace
}  // namespace hm::graph
