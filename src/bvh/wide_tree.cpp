#include "bvh/wide_tree.h"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "base/check.h"

namespace hm {
namespace {

// SAH costs of visiting a node and a leaf, in common units. Values between 0.5 and 2 change the
// number of visits by less than 1 %.
constexpr float kNodeCost = 1.0f;
constexpr float kLeafCost = 1.0f;
constexpr std::uint32_t kTaskCount = 1 << 14;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// cost[i]: the lowest cost of covering a binary subtree with at most i + 1 wide children.
// left[i]: how many of them go to the left binary child; 0 if i children are no more expensive, so
// that cost[i] = cost[i - 1]. left[0] is 0 if the single child is a leaf; if it is a node, left[0]
// is how many of that node's eight children go to the left.
struct Choice {
    float cost[kBvhWidth - 1];
    std::uint8_t left[kBvhWidth - 1];
};

class Collapser {
  public:
    Collapser(std::span<const BinaryNode> nodes, std::uint32_t leaf_size)
        : nodes_(nodes), leaf_size_(leaf_size), choices_(nodes.size()) {
        const BinaryNode& root = nodes[0];
        float size = 0;
        for (int a = 0; a < 3; ++a)
            size = std::max(size, root.hi[a] * 0.5f - root.lo[a] * 0.5f);
        scale_ = size > 0 ? std::clamp(0.5f / size, 1e-37f, 1e37f) : 1;
    }

    WideTree run() {
        choose(0);
        WideTree tree;
        for (int a = 0; a < 3; ++a) {
            tree.bounds.lo[a] = nodes_[0].lo[a];
            tree.bounds.hi[a] = nodes_[0].hi[a];
        }
        tree.root = emit(0, tree, 0);
        return tree;
    }

  private:
    float area(const BinaryNode& n) const {
        float d[3];
        for (int a = 0; a < 3; ++a)
            d[a] = n.hi[a] * scale_ - n.lo[a] * scale_;
        return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    }

    void choose(std::uint32_t node) {
        const std::uint32_t count = nodes_[node].count;
        if (count > kTaskCount) {
            tbb::parallel_invoke([&] { choose(node + 1); },
                                 [&] { choose(right_child(nodes_, node)); });
            choose_here(node);
        } else {
            // Children have higher indices than their parent, so go backwards.
            for (std::uint32_t i = node + 2 * count - 1; i-- > node;)
                choose_here(i);
        }
    }

    // The cheapest distribution of `slots` children between left and right: cost and left count.
    std::pair<float, std::uint8_t> distribute(const Choice& left, const Choice& right,
                                              std::uint32_t slots) const {
        std::pair<float, std::uint8_t> best{kInfinity, 1};
        for (std::uint32_t k = 1; k < slots; ++k) {
            const float cost = left.cost[k - 1] + right.cost[slots - k - 1];
            if (cost < best.first) best = {cost, std::uint8_t(k)};
        }
        return best;
    }

    void choose_here(std::uint32_t node) {
        const BinaryNode& n = nodes_[node];
        Choice& choice = choices_[node];
        const float node_area = area(n);
        if (n.count == 1) {
            std::fill_n(choice.cost, kBvhWidth - 1, node_area * kLeafCost);
            std::fill_n(choice.left, kBvhWidth - 1, std::uint8_t(0));
            return;
        }
        const Choice& left = choices_[node + 1];
        const Choice& right = choices_[right_child(nodes_, node)];
        const auto [children_cost, children_left] = distribute(left, right, kBvhWidth);
        choice.cost[0] = node_area * kNodeCost + children_cost;
        choice.left[0] = children_left;
        if (n.count <= leaf_size_ && node_area * kLeafCost <= choice.cost[0]) {
            choice.cost[0] = node_area * kLeafCost;
            choice.left[0] = 0;
        }
        for (std::uint32_t i = 1; i < kBvhWidth - 1; ++i) {
            const auto [cost, side] = distribute(left, right, i + 1);
            const bool better = cost < choice.cost[i - 1];
            choice.cost[i] = better ? cost : choice.cost[i - 1];
            choice.left[i] = better ? side : std::uint8_t(0);
        }
    }

    // Collects the binary nodes that become wide children when `slots` of them cover `node`.
    void gather(std::uint32_t node, std::uint32_t slots, std::uint32_t* children,
                std::uint32_t& count) const {
        const Choice& choice = choices_[node];
        while (slots > 1 && choice.left[slots - 1] == 0)
            --slots;
        if (slots == 1) {
            children[count++] = node;
            return;
        }
        const std::uint32_t left = choice.left[slots - 1];
        gather(node + 1, left, children, count);
        gather(right_child(nodes_, node), slots - left, children, count);
    }

    std::uint32_t emit(std::uint32_t node, WideTree& tree, std::uint32_t depth) const {
        const std::uint32_t left = choices_[node].left[0];
        if (left == 0) {
            tree.leaves.push_back({nodes_[node].first, nodes_[node].count});
            return kBvhPacket | std::uint32_t(tree.leaves.size() - 1);
        }
        HM_CHECK(depth < kBvhMaxDepth, "depth = {}", depth);
        tree.depth = std::max(tree.depth, depth + 1);
        std::uint32_t children[kBvhWidth];
        std::uint32_t count = 0;
        gather(node + 1, left, children, count);
        gather(right_child(nodes_, node), kBvhWidth - left, children, count);

        const std::size_t index = tree.nodes.size();
        tree.nodes.emplace_back();
        BvhNode wide;
        for (std::uint32_t i = 0; i < kBvhWidth; ++i) {
            const BinaryNode& child = nodes_[children[i < count ? i : 0]];
            for (int a = 0; a < 3; ++a) {
                wide.bounds[2 * a][i] = i < count ? child.lo[a] : kInfinity;
                wide.bounds[2 * a + 1][i] = i < count ? child.hi[a] : -kInfinity;
            }
            wide.child[i] = i < count ? emit(children[i], tree, depth + 1) : kBvhEmpty;
        }
        tree.nodes[index] = wide;
        return kBvhInner | std::uint32_t(index);
    }

    std::span<const BinaryNode> nodes_;
    std::uint32_t leaf_size_;
    float scale_ = 1;
    std::vector<Choice> choices_;
};

}  // namespace

WideTree collapse(std::span<const BinaryNode> nodes, std::uint32_t leaf_size) {
    return Collapser(nodes, leaf_size).run();
}

}  // namespace hm
