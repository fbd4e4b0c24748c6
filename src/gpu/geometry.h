// The vertices and triangles of a scene in device memory.
#pragma once

#include <vector>

#include "gpu/tables.h"
#include "rhi/upload.h"
#include "scene/flatten.h"

namespace hm {

// One entry per geometry of the scene. The buffers also serve to build acceleration structures.
struct GpuGeometry {
    std::vector<rhi::Buffer> buffers;
    std::vector<GeometryAddresses> addresses;
    // Includes the NaN vertex that degenerate triangles refer to.
    std::vector<std::uint32_t> vertex_counts;
    std::uint64_t degenerate_triangles = 0;

    std::uint64_t bytes() const;
    static Result<GpuGeometry> upload(rhi::Device& device, rhi::Uploader& uploader,
                                      const FlatScene& scene);
};

// The exact number of bytes that upload allocates.
std::uint64_t geometry_bytes(const FlatScene& scene);

}  // namespace hm
