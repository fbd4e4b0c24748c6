// A scene's images in device memory, and set 1: the table that shaders index them in.
#pragma once

#include <vector>

#include "rhi/descriptors.h"
#include "rhi/upload.h"
#include "scene/flatten.h"

namespace hm {

class GpuTextures {
  public:
    // Images that path tracing never reads (for occlusion only) are left out.
    static Result<GpuTextures> upload(rhi::Device& device, rhi::Uploader& uploader,
                                      const rhi::SetLayout& layout, const FlatScene& scene);
    const rhi::DescriptorSet& set() const { return set_; }

  private:
    rhi::Sampler sampler_;
    std::vector<rhi::Image> images_;
    rhi::DescriptorSet set_;
};

// What upload will need, without padding.
std::uint64_t texture_bytes(const FlatScene& scene);

}  // namespace hm
