// The CPU's acceleration structure: two levels (meshes, instances), binary trees built with binned
// SAH and collapsed to eight-wide nodes.
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
    bool opaque = true;  // else hits are offered to the any-hit callback
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
    std::uint64_t triangles = 0;             // unique, kept
    std::uint64_t degenerate_triangles = 0;  // zero area or not finite: left out
    std::uint64_t nodes = 0;
    std::uint64_t packets = 0;           // leaves
    std::uint64_t merged_instances = 0;  // whose triangles lie in the static world-space tree
    std::uint64_t bytes = 0;
    double build_seconds = 0;
};

// Owns what BvhView points to. The view lives as long as this does and is not moved.
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

// Meshes that one instance uses are put, in world space, into one tree together; the others keep a
// tree each and are met through their instances. An instance whose world_to_object is not finite
// (a flattened mesh) is put into the common tree too. Uses the current oneTBB arena; the result
// does not depend on its size. Indices must be within their spans, counts of triangles below 2^30.
Bvh build_bvh(std::span<const BvhMesh> meshes, std::span<const BvhInstance> instances);

}  // namespace hm
