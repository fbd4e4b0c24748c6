// The CPU renderer: the shared path-tracing stages under its own BVH, tiles over oneTBB.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "bvh/bvh.h"
#include "film/film.h"
#include "scene/flatten.h"

namespace hm {

// Live while rendering, for progress reports.
struct RenderCounters {
    std::atomic<std::uint64_t> samples{0};
    std::atomic<std::uint64_t> rays{0};
    std::atomic<std::uint64_t> non_finite{0};  // samples that were not numbers: counted as black
};

class CpuRenderer {
  public:
    // Builds the BVH. `scene` must outlive the renderer. threads 0: all cores.
    CpuRenderer(const FlatScene& scene, unsigned threads);
    ~CpuRenderer();

    // Adds samples [begin, end) of each pixel in `crop` to `sums` (rows of crop.width()). Returns
    // early, whole tiles at a time, once `cancel` is set. The same bits whatever the threads.
    // filter_table: make_filter_table (shading/tables).
    void render(const CameraData& camera, const RenderParams& params,
                std::span<const float> filter_table, PixelRect crop, std::uint32_t begin,
                std::uint32_t end, std::span<PixelSum> sums, RenderCounters& counters,
                const std::atomic<bool>& cancel);

    const BvhStats& bvh_stats() const;
    std::string instruction_set() const;  // "baseline", "avx2" or "avx512": what the stages run as

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hm
