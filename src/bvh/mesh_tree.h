// One tree of triangles: gathered from geometries, those that cannot be hit left out, and written
// into packets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/bvh.h"
#include "bvh/wide_tree.h"

namespace hm {

// One geometry's triangles in a tree; placed by `object_to_world` if it is given.
struct TreePart {
    const BvhGeometry* geometry;
    const mat4x3* object_to_world;
    std::uint32_t instance, geometry_index;
};

struct MeshTree {
    std::vector<TreePart> parts;
    std::vector<BvhBox> boxes;  // in the leaves' order
    WideTree tree;
    std::uint64_t degenerate = 0;
};

MeshTree build_mesh_tree(std::vector<TreePart> parts);

// Writes leaf i to packets[i] and its ids to ids[8 * i ...].
void write_packets(const MeshTree& tree, std::span<BvhPacket> packets,
                   std::span<BvhTriangleId> ids);

}  // namespace hm
