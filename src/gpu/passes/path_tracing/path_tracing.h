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

// Pipelines of the same stages. At most one of reorder, record and aovs.
struct PathTracingVariant {
    // The settings that most pictures use (is_usual) are specialization constants: about a tenth
    // faster on an H100. Other settings share one pipeline that reads them from the frame's values:
    // a pipeline for each combination would compile for seconds.
    bool usual = false;
    // Hits are sorted before they are shaded (VK_NV_ray_tracing_invocation_reorder).
    bool reorder = false;
    // The rays of the first sample are recorded, for gpu/bench.
    bool record = false;
    // Samples are also added to a film's AOV planes.
    bool aovs = false;
    auto operator<=>(const PathTracingVariant&) const = default;
};

// Whether these settings are those of the variant `usual` (settings.inl).
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

    // Renders rows range.first_row and following of the accumulation image.
    void record(rhi::Commands& commands, const GpuScene& scene, const PathTracingTargets& targets,
                const TraceRange& range, std::uint32_t rows,
                Launches launches = Launches::loop) const;

  private:
    rhi::SetLayout targets_;  // set 3, pushed
    rhi::PipelineLayout layout_;
    rhi::RayTracingPipeline pipeline_;
};

}  // namespace hm
