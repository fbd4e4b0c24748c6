// What all scenes rendered by one device share: the device itself, the layouts of the descriptor
// sets and the compiled pipelines.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "base/diagnostics.h"
#include "gpu/layouts.h"
#include "gpu/passes/bare_trace/bare_trace.h"
#include "gpu/passes/path_tracing/path_tracing.h"
#include "rhi/device.h"
#include "rhi/pipeline_cache.h"

namespace hm {

class GpuContext {
  public:
    // cache_folder: where compiled pipelines are kept between runs (rhi::default_cache_folder());
    // empty keeps none. `diagnostics`, which must outlive the context, gets a warning if that
    // fails.
    static Result<std::unique_ptr<GpuContext>> create(std::unique_ptr<rhi::Device> device,
                                                      const std::filesystem::path& cache_folder,
                                                      Diagnostics& diagnostics);

    rhi::Device& device() { return *device_; }
    const SceneLayouts& layouts() const { return layouts_; }

    // Compiled on first use, which takes seconds unless the cache has it.
    Result<const PathTracingPass*> path_tracing(const PathTracingVariant& variant);
    Result<const BareTracePass*> bare_trace();

  private:
    explicit GpuContext(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}
    void save_cache();

    Diagnostics& diagnostics_;
    std::unique_ptr<rhi::Device> device_;
    SceneLayouts layouts_;
    rhi::PipelineCache cache_;
    std::map<PathTracingVariant, PathTracingPass> path_tracing_;
    std::optional<BareTracePass> bare_trace_;
};

}  // namespace hm
