// The CPU renderer: the shared path-tracing stages with its own BVH, tiles in parallel with oneTBB.
#pragma once

#include <memory>
#include <string>

#include "bvh/bvh.h"
#include "film/renderer.h"
#include "scene/flatten.h"

namespace hm {

// The instruction set variant of the stages for this CPU: "baseline", "avx2" or "avx512".
std::string cpu_instruction_set();

class CpuRenderer final : public Renderer {
  public:
    // Builds the BVH. `scene` must outlive the renderer. threads 0: all cores.
    CpuRenderer(const FlatScene& scene, unsigned threads);
    ~CpuRenderer() override;

    std::string device() const override;  // "CPU (avx512)"
    Result<void> begin(const RenderJob& job, Film& film) override;
    // Cancelling finishes the tiles in progress. The result is bit-identical for any thread count.
    Result<void> render(std::uint32_t begin, std::uint32_t end, RenderCounters& counters,
                        const std::atomic<bool>& cancel) override;
    Result<void> sync() override { return {}; }
    RendererReport report() const override;

    const BvhStats& bvh_stats() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hm
