// A binary tree collapsed into nodes with eight children, by the cheapest choice of which binary
// nodes to keep (Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through
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

// Leaf children and a leaf root are kBvhPacket | index into `leaves`; what a leaf becomes is the
// caller's business.
struct WideTree {
    std::vector<BvhNode> nodes;
    std::vector<WideLeaf> leaves;
    BvhBounds bounds{};
    std::uint32_t root = kBvhEmpty;
    std::uint32_t depth = 0;  // levels of nodes
};

// leaf_size: the most boxes in a leaf.
WideTree collapse(std::span<const BinaryNode> nodes, std::uint32_t leaf_size);

}  // namespace hm
