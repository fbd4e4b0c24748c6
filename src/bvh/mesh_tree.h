// The tree of one mesh: gathers the triangles of its geometries, skips degenerate ones, and writes
// the leaves as packets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/bvh.h"
#include "bvh/wide_tree.h"

namespace hm {

// One geometry's triangles in a tree, transformed by `object_to_world` unless it is null.
struct TreePart {
    const BvhGeometry* geometry;
    const mat4x3* object_to_world;
    std::uint32_t instance, geometry_index;
};

struct MeshTree {
    std::vector<TreePart> parts;
    std::vector<BvhBox> boxes;  // in leaf order
    WideTree tree;
    std::uint64_t degenerate = 0;
};

MeshTree build_mesh_tree(std::vector<TreePart> parts);

// Writes leaf i to packets[i] and its triangle ids to ids[8 * i] .. ids[8 * i + 7].
void write_packets(const MeshTree& tree, std::span<BvhPacket> packets,
                   std::span<BvhTriangleId> ids);

}  // namespace hm
