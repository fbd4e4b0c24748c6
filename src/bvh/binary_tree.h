// Builds a binary BVH over boxes with binned SAH (Wald, "On fast Construction of SAH-based Bounding
// Volume Hierarchies", 2007), in parallel over subtrees and within large nodes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/view.h"

namespace hm {

struct BvhBox {
    float lo[3];
    std::uint32_t id;  // `id` and `part` are user data
    float hi[3];
    std::uint32_t part;
};

// Covers boxes first .. first + count - 1. A node with one box is a leaf. Nodes are in depth-first
// order: the left child is the next node, and the right child follows the left child's subtree,
// which has 2 * left.count - 1 nodes.
struct BinaryNode {
    float lo[3];
    std::uint32_t first;
    float hi[3];
    std::uint32_t count;
};

inline std::uint32_t right_child(std::span<const BinaryNode> nodes, std::uint32_t node) {
    return node + 2 * nodes[node + 1].count;
}

// Reorders `boxes`, which must be finite and at least one. The depth is at most kBvhMaxDepth.
std::vector<BinaryNode> build_binary_tree(std::vector<BvhBox>& boxes);

}  // namespace hm
