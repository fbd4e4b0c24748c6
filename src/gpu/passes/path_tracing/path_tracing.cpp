#include "gpu/passes/path_tracing/path_tracing.h"

#include <array>
#include <bit>
#include <span>
#include <vector>

#include "graph/usage.h"
#include "shaders/anyhit_aovs.h"
#include "shaders/anyhit_rahit.h"
#include "shaders/closesthit_aovs.h"
#include "shaders/closesthit_extended.h"
#include "shaders/closesthit_extended_aovs.h"
#include "shaders/closesthit_rchit.h"
#include "shaders/miss_aovs.h"
#include "shaders/miss_rmiss.h"
#include "shaders/reference_view_aovs.h"
#include "shaders/reference_view_record.h"
#include "shaders/reference_view_reorder.h"
#include "shaders/reference_view_rgen.h"
#include "shaders/shadow_anyhit.h"
#include "shaders/shadow_miss_rmiss.h"
#include "shading/path/types.h"

namespace hm {
namespace {

// Bindings of set 3. The denoiser's albedo and normal are AOV planes.
constexpr std::uint32_t kAccumulation = 0;
constexpr std::uint32_t kRemoved = 4;
constexpr std::uint32_t kCounters = 5;
constexpr std::uint32_t kRays = 6;
constexpr std::uint32_t kRayCounts = 7;
constexpr std::uint32_t kAovs = 8;
constexpr std::uint32_t kSourceGroups = 9;

// The payloads are contracts between the stages, and devices keep them in registers.
static_assert(sizeof(PathPayload) == 116 && sizeof(ShadowPayload) == 12);

constexpr std::array<rhi::Binding, 7> kTargets = {{
    {kAccumulation, rhi::DescriptorKind::storage_image},
    {kRemoved, rhi::DescriptorKind::storage_image},
    {kCounters, rhi::DescriptorKind::storage_buffer},
    {kRays, rhi::DescriptorKind::storage_buffer},
    {kRayCounts, rhi::DescriptorKind::storage_buffer},
    {kAovs, rhi::DescriptorKind::storage_buffer},
    {kSourceGroups, rhi::DescriptorKind::storage_buffer},
}};

std::uint32_t bits_of(std::uint32_t value) {
    return value;
}
std::uint32_t bits_of(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

rhi::RayTracingPipelineInfo pipeline_info(const PathTracingVariant& variant) {
    rhi::RayTracingPipelineInfo info;
    info.name = "path tracing";
    info.ray_generation = shaders::reference_view_rgen();
    info.misses = {shaders::miss_rmiss(), shaders::shadow_miss_rmiss()};
    info.hit_groups = {
        {variant.extended ? shaders::closesthit_extended() : shaders::closesthit_rchit(),
         shaders::anyhit_rahit()},
        {{}, shaders::shadow_anyhit()}};
    if (variant.aovs) {
        info.name += ", AOVs";
        info.ray_generation = shaders::reference_view_aovs();
        info.misses[0] = shaders::miss_aovs();
        info.hit_groups[0] = {
            variant.extended ? shaders::closesthit_extended_aovs() : shaders::closesthit_aovs(),
            shaders::anyhit_aovs()};
    } else if (variant.record) {
        info.name += ", recorded";
        info.ray_generation = shaders::reference_view_record();
    } else if (variant.reorder) {
        info.ray_generation = shaders::reference_view_reorder();
    }
    info.constants = variant.settings;
    return info;
}

}  // namespace

std::vector<rhi::SpecializationConstant> settings_of(const RenderParams& params) {
    std::vector<rhi::SpecializationConstant> constants;
#define HM_SETTING(id, name) constants.push_back({id, bits_of(params.name)});
#define HM_SETTING_OR_ZERO(id, name) \
    if (bits_of(params.name) == 0) constants.push_back({id, 0});
#include "gpu/passes/path_tracing/settings.inl"
    return constants;
}

Result<PathTracingPass> PathTracingPass::create(rhi::Device& device, const SceneLayouts& layouts,
                                                const PathTracingVariant& variant,
                                                rhi::PipelineCache* cache) {
    PathTracingPass pass;
    HM_TRY_ASSIGN(pass.targets_,
                  rhi::SetLayout::create(device, "path tracing targets", kTargets, true));
    const std::array<const rhi::SetLayout*, 4> sets = {&layouts.scene, &layouts.textures, nullptr,
                                                       &pass.targets_};
    HM_TRY_ASSIGN(pass.layout_,
                  rhi::PipelineLayout::create(device, "path tracing", sets, sizeof(TraceRange)));
    rhi::RayTracingPipelineInfo info = pipeline_info(variant);
    info.layout = &pass.layout_;
    HM_TRY_ASSIGN(pass.pipeline_, rhi::RayTracingPipeline::create(device, info, cache));
    return pass;
}

void PathTracingPass::record(rhi::Commands& commands, const GpuScene& scene,
                             const PathTracingTargets& targets, const TraceRange& range,
                             std::uint32_t rows, Launches launches) const {
    rhi::DescriptorWrites writes(targets_);
    writes.image(kAccumulation, targets.accumulation)
        .image(kRemoved, targets.removed)
        .buffer(kCounters, targets.counters);
    if (targets.rays != nullptr)
        writes.buffer(kRays, *targets.rays).buffer(kRayCounts, *targets.ray_counts);
    if (targets.aovs != nullptr)
        writes.buffer(kAovs, targets.aovs->table())
            .buffer(kSourceGroups, targets.aovs->source_groups());
    commands.bind(pipeline_);
    commands.bind_set(layout_, 0, scene.scene_set());
    commands.bind_set(layout_, 1, scene.texture_set());
    commands.push_set(layout_, 3, writes);
    // A launch adds to the results of the one before.
    const rhi::Scope sums =
        graph::usage_of(graph::PassKind::trace, graph::AccessKind::read_write).scope;
    const rhi::Barrier between{.before = sums, .after = sums};
    TraceRange launch = range;
    while (launch.sample_begin < range.sample_end) {
        if (launches == Launches::one_per_sample) launch.sample_end = launch.sample_begin + 1;
        if (launch.sample_begin > range.sample_begin) commands.barriers(std::span(&between, 1));
        commands.push_constants(layout_, launch);
        commands.trace_rays(pipeline_, targets.accumulation.info().width, rows);
        launch.sample_begin = launch.sample_end;
    }
}

}  // namespace hm
