// The path tracer as a ray-tracing pipeline: reference_view.rgen, closesthit.rchit, miss.rmiss,
// shadow_miss.rmiss and anyhit.rahit over the stages of shading/path.
#pragma once

#include "gpu/aovs.h"
#include "gpu/launch_choice.h"
#include "gpu/scene.h"
#include "rhi/commands.h"
#include "rhi/pipeline_cache.h"
#include "rhi/ray_tracing_pipeline.h"

namespace hm {

// Builds of the same stages.
struct PathTracingVariant {
    // For the settings that nearly all pictures have (is_usual): they are constants.
    bool usual = false;
    // Hits are sorted before they are shaded (VK_NV_ray_tracing_invocation_reorder).
    bool reorder = false;
    // The rays of the first sample are kept, for gpu/bench. Not with `reorder`.
    bool record = false;
    // Samples also add to a film's AOV planes. Not with either of the others.
    bool aovs = false;
    auto operator<=>(const PathTracingVariant&) const = default;
};

// Whether the variant `usual` draws pictures of these settings.
bool is_usual(const RenderParams& params);

// What a launch adds to. Images are in layout general and of the crop's size.
struct PathTracingTargets {
    const rhi::Image& accumulation;  // rgba32f: sums of radiance and alpha
    const rhi::Image& removed;       // r32f: of luminance; 1 x 1 where nothing clamps
    const rhi::Buffer& counters;     // kCounterRows TraceCounters
    // For the variant that records: RecordedRay and RecordedCounts.
    const rhi::Buffer* rays = nullptr;
    const rhi::Buffer* ray_counts = nullptr;
    // For the variant with AOVs.
    const GpuAovs* aovs = nullptr;
};

class PathTracingPass {
  public:
    static Result<PathTracingPass> create(rhi::Device& device, const SceneLayouts& layouts,
                                          PathTracingVariant variant, rhi::PipelineCache* cache);

    // Rows range.first_row and on of the accumulation image.
    void record(rhi::Commands& commands, const GpuScene& scene, const PathTracingTargets& targets,
                const TraceRange& range, std::uint32_t rows,
                Launches launches = Launches::loop) const;

  private:
    rhi::SetLayout targets_;  // set 3, pushed
    rhi::PipelineLayout layout_;
    rhi::RayTracingPipeline pipeline_;
};

}  // namespace hm
