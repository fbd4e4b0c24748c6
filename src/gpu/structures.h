// The acceleration structures of a scene: a bottom-level one per mesh, with its primitives as
// geometries, and the instances over them.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/geometry.h"
#include "rhi/acceleration_build.h"
#include "scene/flatten.h"

namespace hm {

// What is built, as plain data.
struct StructurePlan {
    struct Blas {
        std::uint32_t mesh;
        std::uint32_t baked_instance;  // whose transform the triangles are given; kNone: none's
    };
    struct Placed {
        std::uint32_t instance;
        std::uint32_t blas;
    };
    std::vector<Blas> blas;
    std::vector<Placed> placed;
    std::uint32_t duplicates = 0;  // instances left out
};

// An opaque mesh placed twice by the same transform gets one instance, because at equal distances
// the lower instance wins. Where a transform's inverse exceeds the range of floats, with which
// drivers compute, the mesh is built in world space.
StructurePlan plan_structures(const FlatScene& scene);

struct SceneStructures {
    std::vector<rhi::AccelerationStructure> blas;
    rhi::AccelerationStructure tlas;
    rhi::BuildReport report;
    std::uint32_t instances = 0;
    std::uint32_t duplicates = 0;

    std::uint64_t bytes() const;
    static Result<SceneStructures> build(rhi::Device& device, rhi::Uploader& uploader,
                                         const FlatScene& scene, const GpuGeometry& geometry);
};

}  // namespace hm
