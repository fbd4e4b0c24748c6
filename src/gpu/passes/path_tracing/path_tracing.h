// The path tracer as a ray-tracing pipeline: reference_view.rgen, closesthit.rchit, miss.rmiss,
// shadow_miss.rmiss and anyhit.rahit over the stages of shading/path.
#pragma once

#include <vector>

#include "gpu/aovs.h"
#include "gpu/launch_choice.h"
#include "gpu/scene.h"
#include "rhi/commands.h"
#include "rhi/pipeline_cache.h"
#include "rhi/ray_tracing_pipeline.h"

namespace hm {

// Pipelines of the same stages. At most one of reorder, record and aovs.
struct PathTracingVariant {
    // settings_of a picture: about a tenth faster on an H100 than a pipeline without them, which
    // reads all settings from the frame's values.
    std::vector<rhi::SpecializationConstant> settings{};
    // Hits are sorted before they are shaded (VK_NV_ray_tracing_invocation_reorder).
    bool reorder = false;
    // The rays of the first sample are recorded, for gpu/bench.
    bool record = false;
    // Samples are also added to a film's AOV planes.
    bool aovs = false;
    // The scene has extended materials (shading/material/extended_lobes.h).
    bool extended = false;
    auto operator<=>(const PathTracingVariant&) const = default;
};

// The constants of settings.inl. Few values are possible, so pipelines are mostly found compiled.
std::vector<rhi::SpecializationConstant> settings_of(const RenderParams& params);

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
                                          const PathTracingVariant& variant,
                                          rhi::PipelineCache* cache);

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
