// Measures how fast a device traces whole paths, and the bare rays that they consist of.
#pragma once

#include "film/renderer.h"
#include "gpu/context.h"
#include "gpu/scene.h"
#include "gpu/trace_rates.h"

namespace hm {

// `reorder`: see PathTracingVariant. The picture is job.params' width by height, its paths at most
// 32 events long. Takes 64 bytes of device memory per pixel and event.
Result<TraceRates> measure_tracing(GpuContext& context, GpuScene& scene, const RenderJob& job,
                                   bool reorder, std::uint32_t repeats);

}  // namespace hm
