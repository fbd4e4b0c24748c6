// Acceleration structures and ray-tracing pipelines, on a real device under validation: squares in
// a row, a ray from above each.
#include "rhi/ray_tracing_pipeline.h"

#include <gtest/gtest.h>

#include "rhi/acceleration_build.h"
#include "rhi/commands.h"
#include "rhi/test_device.h"
#include "rhi/upload.h"
#include "shaders/any_radiance.h"
#include "shaders/any_shadow.h"
#include "shaders/hit_rchit.h"
#include "shaders/miss_rmiss.h"
#include "shaders/shadow_miss_rmiss.h"
#include "shaders/trace_rgen.h"

namespace hm::rhi {
namespace {

using test::expect_ok;
using test::value_of;

// A strip of unit squares along x: square i spans [i, i + 1] x [0, 1] at z = 0, two triangles each.
class Strip {
  public:
    Strip(Device& device, std::uint32_t squares) : squares_(squares) {
        std::vector<float> positions;
        std::vector<std::uint32_t> indices;
        for (std::uint32_t i = 0; i <= squares; ++i) {
            const auto x = static_cast<float>(i);
            positions.insert(positions.end(), {x, 0, 0, x, 1, 0});
        }
        for (std::uint32_t i = 0; i < squares; ++i) {
            const std::uint32_t v = 2 * i;
            indices.insert(indices.end(), {v, v + 2, v + 1, v + 2, v + 3, v + 1});
        }
        Uploader uploader = value_of(Uploader::create(device, 1 << 16));
        positions_ = value_of(upload_buffer(
            uploader, device,
            {.name = "positions", .size = positions.size() * 4, .use = BufferUse::build_input},
            std::as_bytes(std::span(positions))));
        indices_ = value_of(upload_buffer(
            uploader, device,
            {.name = "indices", .size = indices.size() * 4, .use = BufferUse::build_input},
            std::as_bytes(std::span(indices))));
        expect_ok(uploader.finish());
    }

    // Squares [begin, end) as one geometry.
    TriangleGeometry geometry(std::uint32_t begin, std::uint32_t end, bool opaque) const {
        return {.positions = positions_.address(),
                .vertex_count = 2 * squares_ + 2,
                .indices = indices_.address() + std::uint64_t{begin} * 24,
                .triangle_count = 2 * (end - begin),
                .opaque = opaque};
    }

  private:
    std::uint32_t squares_;
    Buffer positions_, indices_;
};

TlasInstance instance_at(float x, std::uint32_t custom_index, const AccelerationStructure& blas) {
    TlasInstance instance;
    instance.transform[3] = x;
    instance.custom_index = custom_index;
    instance.blas = blas.address();
    return instance;
}

// The pipeline of test_shaders/, and its results: what each radiance ray hit and whether each
// shadow ray was unoccluded.
class Tracer {
  public:
    explicit Tracer(Device& device) : device_(device) {
        const Binding scene{.binding = 0, .kind = DescriptorKind::acceleration_structure};
        const Binding results{.binding = 0};
        scene_ = value_of(SetLayout::create(device, "scene", std::span(&scene, 1)));
        results_ = value_of(SetLayout::create(device, "results", std::span(&results, 1), true));
        const std::array<const SetLayout*, 2> sets{&scene_, &results_};
        layout_ = value_of(PipelineLayout::create(device, "trace", sets));
        pipeline_ = value_of(RayTracingPipeline::create(
            device, {.name = "trace",
                     .layout = &layout_,
                     .ray_generation = shaders::trace_rgen(),
                     .misses = {shaders::miss_rmiss(), shaders::shadow_miss_rmiss()},
                     .hit_groups = {{shaders::hit_rchit(), shaders::any_radiance()},
                                    {{}, shaders::any_shadow()}}}));
    }

    std::vector<std::array<std::uint32_t, 2>> trace(const AccelerationStructure& tlas,
                                                    std::uint32_t width) {
        const Buffer buffer =
            value_of(Buffer::create(device_, {.name = "results", .size = width * 8u}));
        DescriptorSet set = value_of(DescriptorSet::create(device_, "scene", scene_));
        set.update(DescriptorWrites(scene_).acceleration_structure(0, tlas));
        expect_ok(run_once(device_, "trace", [&](Commands& commands) -> Result<void> {
            commands.bind(pipeline_);
            commands.bind_set(layout_, 0, set);
            commands.push_set(layout_, 1, DescriptorWrites(results_).buffer(0, buffer));
            commands.trace_rays(pipeline_, width, 1);
            return {};
        }));
        std::vector<std::array<std::uint32_t, 2>> results(width);
        expect_ok(read_back(device_, buffer, std::as_writable_bytes(std::span(results))));
        return results;
    }

    const RayTracingPipeline& pipeline() const { return pipeline_; }

  private:
    Device& device_;
    SetLayout scene_, results_;
    PipelineLayout layout_;
    RayTracingPipeline pipeline_;
};

class RhiRays : public test::DeviceTest {};

// Instance 3 at x = 0: squares 0 and 1 are opaque, 2 and 3 are not. Instance 5 is one opaque square
// at x = 6. Radiance rays with key 2 and shadow rays with key 3 pass through non-opaque squares.
TEST_F(RhiRays, EveryStageRuns) {
    const Strip strip(device(), 4);
    const std::vector<BlasInput> inputs = {
        {"two kinds", {strip.geometry(0, 2, true), strip.geometry(2, 4, false)}},
        {"one square", {strip.geometry(0, 1, true)}}};
    BuildReport report;
    const std::vector<AccelerationStructure> blas =
        value_of(build_blas(device(), inputs, {}, report));
    const std::vector<TlasInstance> instances = {instance_at(0, 3, blas[0]),
                                                 instance_at(6, 5, blas[1])};
    const AccelerationStructure tlas = value_of(build_tlas(device(), "scene", instances, report));
    EXPECT_EQ(report.structures, 3u);

    using Seen = std::vector<std::array<std::uint32_t, 2>>;
    Tracer tracer(device());
    const Seen seen = tracer.trace(tlas, 8);
    // The centre lies on the diagonal that both triangles share; either is right.
    const auto either = [&](std::size_t x, std::uint32_t first) {
        return seen[x][0] == first || seen[x][0] == first + 1;
    };
    EXPECT_TRUE(either(0, 1300)) << seen[0][0];
    EXPECT_TRUE(either(1, 1302)) << seen[1][0];
    EXPECT_EQ(seen[2][0], 1u);  // ignored by any-hit, then a miss
    EXPECT_TRUE(either(3, 1312)) << seen[3][0];
    EXPECT_EQ(seen[4][0], 1u);
    EXPECT_EQ(seen[5][0], 1u);
    EXPECT_TRUE(either(6, 1500)) << seen[6][0];
    EXPECT_EQ(seen[7][0], 1u);
    const std::array<std::uint32_t, 8> visible{0, 0, 0, 1, 1, 1, 0, 1};
    for (std::size_t x = 0; x < 8; ++x)
        EXPECT_EQ(seen[x][1], visible[x]) << x;
}

TEST_F(RhiRays, TheTableIsAlignedAndApart) {
    const Tracer tracer(device());
    const auto& limits = device().ray_tracing_limits();
    const auto& regions = tracer.pipeline().regions();
    EXPECT_EQ(regions[0].size, regions[0].stride);
    EXPECT_EQ(regions[1].size, 2 * regions[1].stride);
    EXPECT_EQ(regions[2].size, 2 * regions[2].stride);
    EXPECT_EQ(regions[3].size, 0u);
    for (std::size_t part = 0; part < 3; ++part) {
        EXPECT_EQ(regions[part].deviceAddress % limits.shaderGroupBaseAlignment, 0u);
        EXPECT_EQ(regions[part].stride % limits.shaderGroupHandleAlignment, 0u);
        if (part > 0) {
            EXPECT_GE(regions[part].deviceAddress,
                      regions[part - 1].deviceAddress + regions[part - 1].size);
        }
    }
}

// A small scratch budget gives many batches, and must not change what rays hit.
TEST_F(RhiRays, BatchesShareScratchWithinTheBudget) {
    const Strip strip(device(), 200);
    std::vector<BlasInput> inputs;
    for (std::uint32_t i = 0; i < 20; ++i)
        inputs.push_back(
            {"piece " + std::to_string(i), {strip.geometry(10 * i, 10 * i + 10, true)}});

    BuildReport one, many;
    const auto together = value_of(build_blas(device(), inputs, {}, one));
    EXPECT_EQ(one.batches, 1u);
    EXPECT_EQ(one.structures, 20u);
    const std::uint64_t budget = one.scratch_bytes / 4;
    const auto apart =
        value_of(build_blas(device(), inputs, {.scratch_budget_bytes = budget}, many));
    EXPECT_GE(many.batches, 4u);
    EXPECT_LE(many.scratch_bytes, budget);
    EXPECT_EQ(many.kept_bytes, one.kept_bytes);

    std::vector<TlasInstance> instances;
    for (std::uint32_t i = 0; i < 20; ++i)
        instances.push_back(instance_at(0, i, apart[i]));
    const AccelerationStructure tlas = value_of(build_tlas(device(), "strip", instances, many));
    Tracer tracer(device());
    const auto seen = tracer.trace(tlas, 201);
    for (std::uint32_t x = 0; x < 200; ++x) {
        EXPECT_EQ(seen[x][0] / 100, 10 + x / 10) << x;
        EXPECT_EQ(seen[x][1], 0u) << x;
    }
    EXPECT_EQ(seen[200][0], 1u);
    // A single build that exceeds the budget still succeeds.
    BuildReport alone;
    EXPECT_TRUE(build_blas(device(), std::span(inputs).first(1), {.scratch_budget_bytes = 1}, alone)
                    .has_value());
    EXPECT_EQ(alone.batches, 1u);
}

TEST_F(RhiRays, CompactionKeepsLessAndSaysSo) {
    const Strip strip(device(), 1000);
    const BlasInput input{"strip", {strip.geometry(0, 1000, true)}};
    BuildReport plain, compact;
    const auto full =
        value_of(build_blas(device(), std::span(&input, 1), {.compact = false}, plain));
    const auto small = value_of(build_blas(device(), std::span(&input, 1), {}, compact));
    EXPECT_EQ(plain.built_bytes, plain.kept_bytes);
    EXPECT_EQ(full[0].bytes(), plain.kept_bytes);
    EXPECT_EQ(small[0].bytes(), compact.kept_bytes);
    // Compaction may not shrink the structures of Mesa's software implementation.
    if (device().physical().kind == DeviceKind::cpu)
        EXPECT_LE(compact.kept_bytes, compact.built_bytes);
    else
        EXPECT_LT(compact.kept_bytes, compact.built_bytes);
    EXPECT_GT(compact.kept_bytes, 1000u);

    BuildReport sum = plain;
    sum.add(compact);
    EXPECT_EQ(sum.kept_bytes, plain.kept_bytes + compact.kept_bytes);
    EXPECT_EQ(sum.structures, 2u);
    EXPECT_EQ(sum.scratch_bytes, std::max(plain.scratch_bytes, compact.scratch_bytes));
}

TEST_F(RhiRays, NothingToBuildIsNothingToHit) {
    BuildReport report;
    EXPECT_TRUE(value_of(build_blas(device(), {}, {}, report)).empty());
    EXPECT_EQ(report.batches, 0u);
    const AccelerationStructure tlas = value_of(build_tlas(device(), "empty scene", {}, report));
    Tracer tracer(device());
    EXPECT_EQ(tracer.trace(tlas, 1)[0], (std::array<std::uint32_t, 2>{1, 1}));
}

TEST_F(RhiRays, TooManyInstancesAreRefused) {
    BuildReport report;
    // The span is never read.
    const TlasInstance one;
    const std::size_t many = device().limits().max_instances + 1;
    const auto built = build_tlas(device(), "crowd", std::span(&one, many), report);
    ASSERT_FALSE(built.has_value());
    EXPECT_EQ(built.error().line(), "Vulkan: crowd: " + std::to_string(many) +
                                        " instances; the device supports " +
                                        std::to_string(many - 1));
}

TEST_F(RhiRays, DeeperRecursionThanTheDeviceHasIsRefused) {
    const PipelineLayout layout = value_of(PipelineLayout::create(device(), "empty", {}));
    const Result<RayTracingPipeline> pipeline = RayTracingPipeline::create(
        device(), {.name = "deep",
                   .layout = &layout,
                   .ray_generation = shaders::trace_rgen(),
                   .max_recursion_depth = device().limits().max_recursion_depth + 1});
    ASSERT_FALSE(pipeline.has_value());
    EXPECT_EQ(pipeline.error().line().find("Vulkan: deep: rays that start "), 0u);
}

}  // namespace
}  // namespace hm::rhi
