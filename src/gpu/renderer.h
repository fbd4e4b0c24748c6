// The GPU renderer: the shared path-tracing stages as a Vulkan ray-tracing pipeline.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "film/renderer.h"
#include "gpu/batches.h"
#include "gpu/context.h"
#include "gpu/scene.h"
#include "gpu/sums.h"
#include "graph/graph.h"
#include "rhi/query.h"

namespace hm {

class VulkanRenderer final : public Renderer {
  public:
    // Uploads the scene and builds its acceleration structures. Context and scene must outlive the
    // renderer.
    static Result<std::unique_ptr<VulkanRenderer>> create(GpuContext& context,
                                                          const FlatScene& scene);
    ~VulkanRenderer() override;

    std::string device() const override;
    Result<void> begin(const RenderJob& job, Film& film) override;
    // Submissions take about kBatchMilliseconds; `cancel` is checked between them, except in the
    // middle of a sample that is rendered in bands.
    Result<void> render(std::uint32_t begin, std::uint32_t end, RenderCounters& counters,
                        const std::atomic<bool>& cancel) override;
    Result<void> sync() override;
    RendererReport report() const override;

    const GpuSceneReport& scene_report() const { return scene_->report(); }

  private:
    // A submission that may be in flight while the other is recorded.
    struct Slot {
        std::unique_ptr<graph::Graph> graph;  // for the targets of the last begin
        rhi::Commands commands;
        rhi::Timestamps timestamps;
        rhi::Buffer counters;  // a copy of the device's, after the submission
        rhi::Buffer hits;      // SampleHits, for cryptomattes
        rhi::Buffer hits_back;
        rhi::Ticket ticket = 0;
        Batch batch{};
        bool busy = false;
    };

    VulkanRenderer(GpuContext& context, const FlatScene& flat) : context_(context), flat_(flat) {}
    Result<void> make_slots();
    Result<void> make_aovs(const RenderJob& job);
    Result<void> declare(Slot& slot);
    void declare_hits(Slot& slot, graph::Pass& trace);
    void record_trace(rhi::Commands& commands, Slot& slot);
    Result<void> submit(Slot& slot, const Batch& batch);
    Result<void> finish(Slot& slot, RenderCounters& counters);
    void count(const Slot& slot, RenderCounters& counters);

    GpuContext& context_;
    const FlatScene& flat_;
    std::unique_ptr<GpuScene> scene_;
    const PathTracingPass* pass_ = nullptr;
    std::array<Slot, 2> slots_;
    rhi::Buffer counters_;
    TraceCounters counted_{};  // what `counters_` had come to, modulo 2^32

    double trace_seconds_ = 0;

    Film* film_ = nullptr;
    GpuSums sums_;
    BatchSizer sizer_;
    std::vector<std::uint32_t> added_;  // samples per row of the film since the last sync
    std::optional<GpuAovs> aovs_;
    std::vector<std::uint32_t> surfaces_;  // for counting ids; empty: not asked for
    std::vector<IdList> ids_;              // the film's, with what was hit since the last sync
};

}  // namespace hm
