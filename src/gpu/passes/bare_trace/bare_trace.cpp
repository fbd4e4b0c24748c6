#include "gpu/passes/bare_trace/bare_trace.h"

#include <array>

#include "shaders/bare_trace_rchit.h"
#include "shaders/bare_trace_rgen.h"
#include "shaders/bare_trace_rmiss.h"

namespace hm {
namespace {

// Bindings of set 3.
constexpr std::uint32_t kRays = 0;
constexpr std::uint32_t kCounts = 1;
constexpr std::uint32_t kHits = 2;

constexpr std::array<rhi::Binding, 3> kBindings = {{
    {kRays, rhi::DescriptorKind::storage_buffer},
    {kCounts, rhi::DescriptorKind::storage_buffer},
    {kHits, rhi::DescriptorKind::storage_buffer},
}};

}  // namespace

Result<RecordedRays> RecordedRays::create(rhi::Device& device, std::uint32_t pixels,
                                          std::uint32_t rays_per_pixel) {
    RecordedRays rays;
    rays.rays_per_pixel = rays_per_pixel;
    const std::uint64_t count = std::uint64_t(pixels) * rays_per_pixel;
    HM_TRY_ASSIGN(rays.rays,
                  rhi::Buffer::create(device, {"recorded rays", count * sizeof(RecordedRay)}));
    HM_TRY_ASSIGN(rays.counts, rhi::Buffer::create(device, {"counts of recorded rays",
                                                            pixels * sizeof(RecordedCounts)}));
    return rays;
}

Result<BareTracePass> BareTracePass::create(rhi::Device& device, const SceneLayouts& layouts,
                                            rhi::PipelineCache* cache) {
    BareTracePass pass;
    HM_TRY_ASSIGN(pass.rays_, rhi::SetLayout::create(device, "recorded rays", kBindings, true));
    const std::array<const rhi::SetLayout*, 4> sets = {&layouts.scene, nullptr, nullptr,
                                                       &pass.rays_};
    HM_TRY_ASSIGN(pass.layout_,
                  rhi::PipelineLayout::create(device, "bare trace", sets, sizeof(BareRange)));
    rhi::RayTracingPipelineInfo info;
    info.name = "bare trace";
    info.layout = &pass.layout_;
    info.ray_generation = shaders::bare_trace_rgen();
    info.misses = {shaders::bare_trace_rmiss()};
    info.hit_groups = {{shaders::bare_trace_rchit(), {}}};
    HM_TRY_ASSIGN(pass.pipeline_, rhi::RayTracingPipeline::create(device, info, cache));
    HM_TRY_ASSIGN(pass.hits_, rhi::Buffer::create(device, {"bare trace, hits", 16}));
    return pass;
}

void BareTracePass::record(rhi::Commands& commands, const GpuScene& scene, const RecordedRays& rays,
                           std::uint32_t kinds, std::uint32_t width, std::uint32_t height,
                           std::uint32_t depth) const {
    rhi::DescriptorWrites writes(rays_);
    writes.buffer(kRays, rays.rays).buffer(kCounts, rays.counts).buffer(kHits, hits_);
    commands.bind(pipeline_);
    commands.bind_set(layout_, 0, scene.scene_set());
    commands.push_set(layout_, 3, writes);
    commands.push_constants(layout_, BareRange{width * height, kinds});
    commands.trace_rays(pipeline_, width, height, depth);
}

}  // namespace hm
