// A ray-tracing pipeline and its shader binding table:
//
//   [ray generation] [miss 0, miss 1, ...] [hit group 0, hit group 1, ...]
//
// so the miss index and the hit group offset of traceRayEXT are indices into the lists below (the
// stride between geometries is 0).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "rhi/buffer.h"
#include "rhi/pipeline.h"

namespace hm::rhi {

// An empty span means no such stage.
struct HitGroup {
    Spirv closest_hit;
    Spirv any_hit;
};

struct RayTracingPipelineInfo {
    std::string name;
    const PipelineLayout* layout = nullptr;
    Spirv ray_generation;
    std::vector<Spirv> misses;
    std::vector<HitGroup> hit_groups;
    std::uint32_t max_recursion_depth = 1;
    std::vector<SpecializationConstant> constants;  // of all stages
};

class RayTracingPipeline {
  public:
    RayTracingPipeline() = default;
    static Result<RayTracingPipeline> create(Device& device, const RayTracingPipelineInfo& info,
                                             PipelineCache* cache = nullptr);
    VkPipeline handle() const { return handle_.get(); }
    // Ray generation, miss, hit and callable regions: the arguments of vkCmdTraceRaysKHR.
    const std::array<VkStridedDeviceAddressRegionKHR, 4>& regions() const { return regions_; }

  private:
    Result<void> make_table(Device& device, const RayTracingPipelineInfo& info);

    Handle<VkPipeline, &vkDestroyPipeline> handle_;
    Buffer table_;
    std::array<VkStridedDeviceAddressRegionKHR, 4> regions_{};
};

}  // namespace hm::rhi
