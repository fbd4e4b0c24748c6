// Collapses a binary tree into nodes with eight children, choosing the binary nodes to keep by
// minimal SAH cost (Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through
// Compressed Wide BVHs", 2017, section 3.2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/binary_tree.h"

namespace hm {

// A range of boxes that becomes one leaf.
struct WideLeaf {
    std::uint32_t first, count;
};

// References to leaves (children or root) are kBvhPacket | index into `leaves`; the caller decides
// what a leaf becomes.
struct WideTree {
    std::vector<BvhNode> nodes;
    std::vector<WideLeaf> leaves;
    BvhBounds bounds{};
    std::uint32_t root = kBvhEmpty;
    std::uint32_t depth = 0;  // number of node levels
};

// leaf_size: the maximum number of boxes in a leaf.
WideTree collapse(std::span<const BinaryNode> nodes, std::uint32_t leaf_size);

}  // namespace hm
