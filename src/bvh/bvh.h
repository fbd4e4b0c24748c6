// The CPU's acceleration structure: a two-level BVH (meshes, instances), built as binary trees with
// binned SAH and collapsed to eight-wide nodes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/view.h"
#include "shading/structs.h"

namespace hm {

struct BvhGeometry {
    std::span<const Vertex> vertices;
    std::span<const uvec3> triangles;
    bool opaque = true;  // false: the any-hit callback is called for hits
};

struct BvhMesh {
    std::vector<BvhGeometry> geometries;
};

struct BvhInstance {
    std::uint32_t mesh = 0;
    mat4x3 object_to_world;
    mat4x3 world_to_object;
};

struct BvhStats {
    std::uint64_t triangles = 0;             // unique, without degenerate ones
    std::uint64_t degenerate_triangles = 0;  // skipped: zero area, infinite or NaN
    std::uint64_t nodes = 0;
    std::uint64_t packets = 0;           // leaves
    std::uint64_t merged_instances = 0;  // instances whose triangles are in the world-space tree
    std::uint64_t bytes = 0;
    double build_seconds = 0;
};

// Owns the memory that BvhView points to. A view is valid while this object lives and is not moved.
struct Bvh {
    std::vector<BvhNode> nodes;
    std::vector<BvhPacket> packets;
    std::vector<BvhTriangleId> ids;
    std::vector<BvhInstanceRef> instances;
    BvhBounds bounds{};
    std::uint32_t root = kBvhEmpty;
    BvhStats stats;

    BvhView view() const {
        return {nodes.data(), packets.data(), ids.data(), instances.data(), bounds, root};
    }
};

// Meshes used by a single instance are merged, in world space, into one static tree; each other
// mesh gets its own tree, which is traversed through its instances. An instance whose
// world_to_object is not finite (a flattened mesh) is merged into the static tree too. Runs in the
// current oneTBB arena; the result does not depend on the number of threads. Indices must be in
// range and triangle counts below 2^30.
Bvh build_bvh(std::span<const BvhMesh> meshes, std::span<const BvhInstance> instances);

}  // namespace hm
