// The bare tracer: only traces the rays that the recording build of the path tracer stored. Its
// time is a lower bound for any renderer of these rays.
#pragma once

#include "gpu/scene.h"
#include "rhi/commands.h"
#include "rhi/pipeline_cache.h"
#include "rhi/ray_tracing_pipeline.h"

namespace hm {

struct RecordedRays {
    rhi::Buffer rays;                  // RecordedRay
    rhi::Buffer counts;                // RecordedCounts, one per pixel
    std::uint32_t rays_per_pixel = 0;  // there is room for

    static Result<RecordedRays> create(rhi::Device& device, std::uint32_t pixels,
                                       std::uint32_t rays_per_pixel);
};

class BareTracePass {
  public:
    static Result<BareTracePass> create(rhi::Device& device, const SceneLayouts& layouts,
                                        rhi::PipelineCache* cache);

    // width x height pixels; `depth` invocations share the rays of a pixel. kinds: kRecorded*.
    void record(rhi::Commands& commands, const GpuScene& scene, const RecordedRays& rays,
                std::uint32_t kinds, std::uint32_t width, std::uint32_t height,
                std::uint32_t depth) const;

  private:
    rhi::SetLayout rays_;  // set 3, pushed
    rhi::PipelineLayout layout_;
    rhi::RayTracingPipeline pipeline_;
    rhi::Buffer hits_;
};

}  // namespace hm
