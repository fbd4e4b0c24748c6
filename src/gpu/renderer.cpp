#include "gpu/renderer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "base/check.h"
#include "scene/surface_names.h"

namespace hm {
namespace {

std::string name_of(std::optional<Launches> launches) {
    if (!launches) return "";
    return *launches == Launches::loop ? "loop" : "launches";
}

using TraceCounterRows = std::array<TraceCounters, kCounterRows>;

}  // namespace

Result<std::unique_ptr<VulkanRenderer>> VulkanRenderer::create(GpuContext& context,
                                                               const FlatScene& scene) {
    std::unique_ptr<VulkanRenderer> renderer(new VulkanRenderer(context, scene));
    HM_TRY_ASSIGN(renderer->scene_, GpuScene::create(context.device(), context.layouts(), scene));
    HM_TRY(renderer->make_slots());
    return renderer;
}

VulkanRenderer::~VulkanRenderer() {
    // Nothing is destroyed while in use; a lost device no longer uses anything.
    (void)context_.device().wait_idle();
}

std::string VulkanRenderer::device() const {
    return context_.device().physical().name + " (Vulkan)";
}

RendererReport VulkanRenderer::report() const {
    const GpuSceneReport& s = scene_->report();
    const rhi::PhysicalDevice& device = context_.device().physical();
    return {.kind = "vulkan",
            .device = device.name,
            .variant = device.driver,
            .upload_seconds = s.upload_seconds,
            .build_seconds = s.build_seconds,
            .trace_seconds = trace_seconds_,
            .structure_bytes = s.structure_bytes,
            .device_bytes = context_.device().memory_use().used_bytes,
            .launches = name_of(sizer_.decided()),
            .structure = {{"triangles", s.triangles},
                          {"degenerate_triangles", s.degenerate_triangles},
                          {"meshes", s.build.structures},
                          {"instances", s.instances},
                          {"duplicate_instances", s.duplicate_instances}}};
}

Result<void> VulkanRenderer::make_slots() {
    rhi::Device& device = context_.device();
    HM_TRY_ASSIGN(counters_, rhi::Buffer::create(device, {"counters", sizeof(TraceCounterRows)}));
    HM_TRY(rhi::run_once(device, "clear counters", [&](rhi::Commands& commands) -> Result<void> {
        commands.fill(counters_, 0);
        return {};
    }));
    for (Slot& slot : slots_) {
        HM_TRY_ASSIGN(slot.timestamps, rhi::Timestamps::create(device, "submission", 2));
        HM_TRY_ASSIGN(
            slot.counters,
            rhi::Buffer::create(device, {"counters, read back", sizeof(TraceCounterRows),
                                         rhi::BufferUse::none, rhi::MemoryKind::readback}));
    }
    return {};
}

Result<void> VulkanRenderer::begin(const RenderJob& job, Film& film) {
    HM_TRY(context_.device().wait_idle());
    film_ = &film;
    added_.assign(film.crop.height(), 0);
    HM_TRY(scene_->set_frame(job));
    HM_TRY(make_aovs(job));
    std::uint64_t most = context_.device().limits().max_rays_per_trace;
    if (!surfaces_.empty()) most = std::min(most, kNotedSamples);
    sizer_ = BatchSizer(film.crop.width(), film.crop.height(), most);
    HM_TRY_ASSIGN(sums_, GpuSums::create(context_.device(), film, job.params.max_radiance > 0));
    for (Slot& slot : slots_)
        HM_TRY(declare(slot));
    return {};
}

Result<void> VulkanRenderer::make_aovs(const RenderJob& job) {
    rhi::Device& device = context_.device();
    const bool with_aovs = film_->selection.needs_planes();
    PathTracingVariant variant;
    variant.aovs = with_aovs;
    variant.extended = scene_->has_extended_materials();
    variant.settings = settings_of(job.params);
    variant.reorder = !with_aovs && device.limits().reorders_rays;
    HM_TRY_ASSIGN(pass_, context_.path_tracing(variant));
    aovs_.reset();
    surfaces_.clear();
    ids_ = film_->ids;
    if (!with_aovs) return {};
    HM_TRY_ASSIGN(aovs_, GpuAovs::create(device, flat_, job, *film_));
    if (!film_->selection.wants_ids()) return {};
    surfaces_ = first_surfaces(flat_);
    const std::uint64_t room = std::max<std::uint64_t>(kNotedSamples, film_->crop.width());
    for (Slot& slot : slots_) {
        const std::uint64_t bytes = room * sizeof(SampleHit);
        HM_TRY_ASSIGN(slot.hits, rhi::Buffer::create(device, {"hits", bytes}));
        HM_TRY_ASSIGN(slot.hits_back,
                      rhi::Buffer::create(device, {"hits, read back", bytes, rhi::BufferUse::none,
                                                   rhi::MemoryKind::readback}));
    }
    return {};
}

// One submission. The graph makes it wait for the other slot's, which adds to the same sums.
Result<void> VulkanRenderer::declare(Slot& slot) {
    slot.graph = std::make_unique<graph::Graph>(context_.device(), "trace");
    graph::Ref counters = slot.graph->import(counters_);
    graph::Pass trace = slot.graph->pass("trace", graph::PassKind::trace);
    trace.updates(slot.graph->import(sums_.accumulation()));
    trace.updates(slot.graph->import(sums_.removed()));
    counters = trace.updates(counters);
    if (aovs_)
        for (const rhi::Buffer& plane : aovs_->planes())
            trace.updates(slot.graph->import(plane));
    if (!surfaces_.empty()) declare_hits(slot, trace);
    trace.records([this, &slot](rhi::Commands& commands) { record_trace(commands, slot); });
    graph::Pass back = slot.graph->pass("counters back", graph::PassKind::copy);
    back.reads(counters);
    back.writes(slot.graph->import(slot.counters));
    back.records(
        [this, &slot](rhi::Commands& commands) { commands.copy(counters_, slot.counters); });
    return slot.graph->compile();
}

// Before the trace all hits are cleared to kNone; after it they are copied to the host.
void VulkanRenderer::declare_hits(Slot& slot, graph::Pass& trace) {
    graph::Ref hits = slot.graph->import(slot.hits);
    graph::Pass none = slot.graph->pass("no hits", graph::PassKind::copy);
    hits = none.writes(hits);
    none.records([&slot](rhi::Commands& commands) { commands.fill(slot.hits, kNone); });
    hits = trace.updates(hits);
    graph::Pass back = slot.graph->pass("hits back", graph::PassKind::copy);
    back.reads(hits);
    back.writes(slot.graph->import(slot.hits_back));
    back.records([this, &slot](rhi::Commands& commands) {
        const std::uint64_t samples = slot.batch.samples(film_->crop.width());
        commands.copy(slot.hits, slot.hits_back, 0, 0, samples * sizeof(SampleHit));
    });
}

void VulkanRenderer::record_trace(rhi::Commands& commands, Slot& slot) {
    const std::uint64_t hits = surfaces_.empty() ? 0 : slot.hits.address();
    const Batch& batch = slot.batch;
    const TraceRange range = {.crop_x = film_->crop.x0,
                              .crop_y = film_->crop.y0,
                              .first_row = batch.first_row,
                              .sample_begin = batch.sample_begin,
                              .sample_end = batch.sample_end,
                              .hits = uvec2(std::uint32_t(hits), std::uint32_t(hits >> 32)),
                              .noted_begin = batch.sample_begin,
                              .noted_samples = batch.samples_per_pixel()};
    PathTracingTargets targets{sums_.accumulation(), sums_.removed(), counters_};
    targets.aovs = aovs_ ? &*aovs_ : nullptr;
    slot.timestamps.write(commands, 0);
    pass_->record(commands, *scene_, targets, range, batch.rows, batch.launches);
    slot.timestamps.write(commands, 1);
}

Result<void> VulkanRenderer::submit(Slot& slot, const Batch& batch) {
    if (slot.commands.handle() == VK_NULL_HANDLE) {
        HM_TRY_ASSIGN(slot.commands, rhi::Commands::begin(context_.device(), "trace"));
    } else {
        HM_TRY(slot.commands.begin_again());
    }
    slot.batch = batch;
    slot.timestamps.reset(slot.commands);
    slot.graph->record(slot.commands);
    HM_TRY_ASSIGN(slot.ticket, context_.device().submit(slot.commands));
    slot.busy = true;
    return {};
}

Result<void> VulkanRenderer::finish(Slot& slot, RenderCounters& counters) {
    if (!slot.busy) return {};
    HM_TRY(context_.device().wait(slot.ticket));
    slot.busy = false;
    HM_TRY_ASSIGN(const std::vector<double> times, slot.timestamps.milliseconds(2));
    sizer_.learn(slot.batch, times[1]);
    trace_seconds_ += times[1] * 1e-3;
    const std::uint32_t samples = slot.batch.samples_per_pixel();
    for (std::uint32_t row = 0; row < slot.batch.rows; ++row)
        added_[slot.batch.first_row + row] += samples;
    count(slot, counters);
    if (!surfaces_.empty()) {
        std::vector<SampleHit> hits(slot.batch.samples(film_->crop.width()));
        std::memcpy(hits.data(), slot.hits_back.mapped().data(), hits.size() * sizeof(SampleHit));
        count_hits(hits, slot.batch, film_->crop.width(), surfaces_, ids_);
    }
    return {};
}

// The device's counters wrap at 2^32, which is far more than one submission adds.
void VulkanRenderer::count(const Slot& slot, RenderCounters& counters) {
    TraceCounterRows rows{};
    std::memcpy(rows.data(), slot.counters.mapped().data(), sizeof(rows));
    TraceCounters now{};
    for (const TraceCounters& row : rows) {
        now.rays += row.rays;
        now.non_finite += row.non_finite;
    }
    counters.samples += slot.batch.samples(film_->crop.width());
    counters.rays += now.rays - counted_.rays;
    counters.non_finite += now.non_finite - counted_.non_finite;
    counted_ = now;
}

Result<void> VulkanRenderer::render(std::uint32_t begin, std::uint32_t end,
                                    RenderCounters& counters, const std::atomic<bool>& cancel) {
    HM_CHECK(film_ != nullptr, "samples {} to {} before begin", begin, end);
    BatchCutter cutter(film_->crop.height(), begin, end);
    std::size_t turn = 0;
    for (; !cutter.is_even() || !cancel.load(std::memory_order_relaxed); ++turn) {
        // The time of the older of the two submissions decides how long the next may be.
        HM_TRY(finish(slots_[turn % 2], counters));
        const std::optional<Batch> batch = cutter.next(sizer_);
        if (!batch) break;
        HM_TRY(submit(slots_[turn % 2], *batch));
    }
    HM_TRY(finish(slots_[turn % 2], counters));
    return finish(slots_[(turn + 1) % 2], counters);
}

Result<void> VulkanRenderer::sync() {
    HM_CHECK(film_ != nullptr, "sync before begin");
    HM_TRY(context_.device().wait_idle());
    rhi::Device& device = context_.device();
    HM_TRY_ASSIGN(const GpuSums::Values sums, sums_.download(device));
    if (aovs_) {
        HM_TRY_ASSIGN(std::vector<std::vector<float>> planes, aovs_->download(device));
        for (std::size_t p = 0; p < planes.size(); ++p)
            film_->planes[p].values = std::move(planes[p]);
        film_->ids = ids_;
    }
    const std::uint32_t width = film_->crop.width();
    for (std::size_t i = 0; i < film_->sums.size(); ++i) {
        PixelSum& sum = film_->sums[i];
        sum.radiance = vec3(sums.radiance[i]);
        sum.alpha = sums.radiance[i].w;
        sum.weight += float(added_[i / width]);
        if (!sums.removed.empty()) sum.removed = sums.removed[i];
    }
    added_.assign(added_.size(), 0);
    return {};
}

}  // namespace hm
