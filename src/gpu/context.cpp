#include "gpu/context.h"

namespace hm {

Result<std::unique_ptr<GpuContext>> GpuContext::create(std::unique_ptr<rhi::Device> device,
                                                       const std::filesystem::path& cache_folder,
                                                       Diagnostics& diagnostics) {
    std::unique_ptr<GpuContext> context(new GpuContext(diagnostics));
    context->device_ = std::move(device);
    HM_TRY_ASSIGN(context->layouts_, SceneLayouts::create(*context->device_));
    HM_TRY_ASSIGN(context->cache_,
                  rhi::PipelineCache::open(*context->device_, cache_folder, diagnostics));
    return context;
}

Result<const PathTracingPass*> GpuContext::path_tracing(const PathTracingVariant& variant) {
    const auto found = path_tracing_.find(variant);
    if (found != path_tracing_.end()) return &found->second;
    HM_TRY_ASSIGN(PathTracingPass pass,
                  PathTracingPass::create(*device_, layouts_, variant, &cache_));
    save_cache();
    return &path_tracing_.emplace(variant, std::move(pass)).first->second;
}

Result<const BareTracePass*> GpuContext::bare_trace() {
    if (!bare_trace_) {
        HM_TRY_ASSIGN(bare_trace_, BareTracePass::create(*device_, layouts_, &cache_));
        save_cache();
    }
    return &*bare_trace_;
}

// A failure is a warning: the next run compiles again, and pictures are the same.
void GpuContext::save_cache() {
    const Result<void> saved = cache_.save();
    if (saved) return;
    const Error& error = saved.error();
    diagnostics_.warn(error.file, error.location,
                      "compiled pipelines can't be kept for the next run: " + error.message);
}

}  // namespace hm
