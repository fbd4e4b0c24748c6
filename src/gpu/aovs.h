// AOVs on a device: the film's planes by device address, the tables of the AOV build of
// the path tracer, and what its samples hit.
#pragma once

#include <span>
#include <vector>

#include "film/renderer.h"
#include "gpu/batches.h"
#include "gpu/tables.h"
#include "rhi/upload.h"
#include "scene/flatten.h"

namespace hm {

class GpuAovs {
  public:
    // Starts from the current values of the film's planes.
    static Result<GpuAovs> create(rhi::Device& device, const FlatScene& scene, const RenderJob& job,
                                  const Film& film);

    const rhi::Buffer& table() const { return table_; }  // AovParams and AovAddresses
    const rhi::Buffer& source_groups() const { return source_groups_; }
    std::span<const rhi::Buffer> planes() const { return planes_; }  // as the film's
    // In the order of the film's planes.
    Result<std::vector<std::vector<float>>> download(rhi::Device& device) const;

  private:
    rhi::Buffer table_;
    rhi::Buffer source_groups_;
    rhi::Buffer next_transforms_;
    rhi::Buffer next_positions_;
    std::vector<rhi::Buffer> moved_;  // what next_positions_ refers to
    std::vector<rhi::Buffer> planes_;
};

// Samples of a submission whose hits are recorded: the capacity of the hit buffer.
inline constexpr std::uint64_t kNotedSamples = 1u << 22;

// Counts the hits of a batch in `ids`, which is per pixel of the film. surfaces: first_surfaces
// (scene/surface_names).
void count_hits(std::span<const SampleHit> hits, const Batch& batch, std::uint32_t width,
                std::span<const std::uint32_t> surfaces, std::vector<IdList>& ids);

}  // namespace hm
