#include "bvh/bvh.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "bvh/mesh_tree.h"

namespace hm {
namespace {

constexpr std::uint32_t kStatic = 0;  // index of the world-space tree; the meshes' trees follow

struct Plan {
    std::vector<std::vector<TreePart>> trees;  // [kStatic], then one per shared mesh
    std::vector<std::uint32_t> tree_of_mesh;   // kStatic if the mesh is not shared
    std::vector<std::uint32_t> instances;      // instances not merged into the static tree
    std::uint64_t merged = 0;
};

bool is_invertible(const mat4x3& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return glm::determinant(glm::dmat3(m)) != 0;
}

void add_parts(std::vector<TreePart>& parts, const BvhMesh& mesh, const mat4x3* object_to_world,
               std::uint32_t instance) {
    for (std::uint32_t g = 0; g < mesh.geometries.size(); ++g)
        parts.push_back({&mesh.geometries[g], object_to_world, instance, g});
}

Plan make_plan(std::span<const BvhMesh> meshes, std::span<const BvhInstance> instances) {
    std::vector<std::uint32_t> uses(meshes.size(), 0);
    for (const BvhInstance& instance : instances) {
        HM_CHECK(instance.mesh < meshes.size(), "mesh {} of {}", instance.mesh, meshes.size());
        if (is_invertible(instance.world_to_object)) ++uses[instance.mesh];
    }
    Plan plan;
    plan.trees.resize(1);
    plan.tree_of_mesh.assign(meshes.size(), kStatic);
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const BvhInstance& instance = instances[i];
        const BvhMesh& mesh = meshes[instance.mesh];
        if (uses[instance.mesh] == 1 || !is_invertible(instance.world_to_object)) {
            add_parts(plan.trees[kStatic], mesh, &instance.object_to_world, i);
            ++plan.merged;
            continue;
        }
        plan.instances.push_back(i);
        std::uint32_t& tree = plan.tree_of_mesh[instance.mesh];
        if (tree != kStatic) continue;
        tree = std::uint32_t(plan.trees.size());
        add_parts(plan.trees.emplace_back(), mesh, nullptr, 0);
    }
    return plan;
}

// A child reference, offset by the `nodes` and `packets` that precede the tree's own.
std::uint32_t moved(std::uint32_t ref, std::size_t nodes, std::size_t packets) {
    if (ref == kBvhEmpty) return ref;
    return ref + std::uint32_t((ref & kBvhKindMask) == kBvhInner ? nodes : packets);
}

// Concatenates the trees' nodes, packets and ids in `bvh` and updates the trees' roots to match.
void append_trees(Bvh& bvh, std::span<MeshTree> trees) {
    std::vector<std::size_t> first_node;
    std::vector<std::size_t> first_packet;
    std::size_t nodes = 0;
    std::size_t packets = 0;
    for (const MeshTree& t : trees) {
        first_node.push_back(nodes);
        first_packet.push_back(packets);
        nodes += t.tree.nodes.size();
        packets += t.tree.leaves.size();
    }
    HM_CHECK(packets < kBvhInstance - kBvhPacket, "{} packets", packets);
    bvh.nodes.resize(nodes);
    bvh.packets.resize(packets);
    bvh.ids.resize(packets * kBvhWidth);
    tbb::parallel_for(std::size_t(0), trees.size(), [&](std::size_t t) {
        WideTree& tree = trees[t].tree;
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            BvhNode node = tree.nodes[i];
            for (std::uint32_t& child : node.child)
                child = moved(child, first_node[t], first_packet[t]);
            bvh.nodes[first_node[t] + i] = node;
        }
        tree.root = moved(tree.root, first_node[t], first_packet[t]);
        write_packets(trees[t], std::span(bvh.packets).subspan(first_packet[t], tree.leaves.size()),
                      std::span(bvh.ids).subspan(kBvhWidth * first_packet[t],
                                                 kBvhWidth * tree.leaves.size()));
    });
}

// World-space bounds of an instance: the preimage of the mesh's box under world_to_object, the
// transform that traversal uses. They are padded by the rounding error of transforming rays whose
// origin coordinates are at most `reach` in magnitude.
BvhBounds instance_bounds(const BvhBounds& object, const mat4x3& world_to_object,
                          const glm::dvec3& reach) {
    const glm::dmat3 m(world_to_object);
    const glm::dvec3 shift(world_to_object[3]);
    const glm::dmat3 inverse = glm::inverse(m);
    const auto absolute = [](glm::dmat3 x) {
        for (int c = 0; c < 3; ++c)
            x[c] = glm::abs(x[c]);
        return x;
    };
    const glm::dvec3 lo(object.lo[0], object.lo[1], object.lo[2]);
    const glm::dvec3 hi(object.hi[0], object.hi[1], object.hi[2]);
    const glm::dvec3 centre = inverse * (0.5 * (lo + hi) - shift);
    const glm::dvec3 half = absolute(inverse) * (0.5 * (hi - lo));
    // A transformed coordinate has four terms and three additions: its rounding error is at most
    // 4 * 2^-24 times the sum of the terms' magnitudes.
    const glm::dvec3 rounding =
        8 * 0x1p-24 * (absolute(inverse) * (absolute(m) * reach + glm::abs(shift)));
    BvhBounds world;
    for (int a = 0; a < 3; ++a) {
        const auto infinity = std::numeric_limits<float>::infinity();
        world.lo[a] = std::nextafter(float(centre[a] - half[a] - rounding[a]), -infinity);
        world.hi[a] = std::nextafter(float(centre[a] + half[a] + rounding[a]), infinity);
    }
    return world;
}

BvhInstanceRef instance_ref(const BvhInstance& instance, std::uint32_t index,
                            const WideTree& tree) {
    BvhInstanceRef ref;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r)
            ref.world_to_object[c][r] = instance.world_to_object[c][r];
    ref.bounds = tree.bounds;
    ref.root = tree.root;
    ref.instance = index;
    return ref;
}

// Builds the top-level tree over the instances and the static tree, which is treated as one more
// instance.
void add_top_level(Bvh& bvh, const WideTree& static_tree, std::span<const BvhInstance> instances) {
    std::vector<BvhBox> boxes;
    const auto add_box = [&](const BvhBounds& b, std::uint32_t ref) {
        boxes.push_back({{b.lo[0], b.lo[1], b.lo[2]}, ref, {b.hi[0], b.hi[1], b.hi[2]}, 0});
    };
    const auto bounds_of = [&](const BvhInstanceRef& ref, const glm::dvec3& reach) {
        return instance_bounds(ref.bounds, instances[ref.instance].world_to_object, reach);
    };
    glm::dvec3 reach(0);
    const auto extend_reach = [&](const BvhBounds& b) {
        for (int a = 0; a < 3; ++a)
            reach[a] = std::max({reach[a], std::abs(double(b.lo[a])), std::abs(double(b.hi[a]))});
    };
    if (static_tree.root != kBvhEmpty) {
        add_box(static_tree.bounds, static_tree.root);
        extend_reach(static_tree.bounds);
    }
    for (const BvhInstanceRef& ref : bvh.instances)
        extend_reach(bounds_of(ref, glm::dvec3(0)));
    for (std::uint32_t i = 0; i < bvh.instances.size(); ++i)
        add_box(bounds_of(bvh.instances[i], reach), kBvhInstance | i);

    WideTree top = collapse(build_binary_tree(boxes), 1);
    const auto resolve = [&](std::uint32_t ref) {
        if (ref == kBvhEmpty) return ref;
        const std::uint32_t index = ref & ~kBvhKindMask;
        if ((ref & kBvhKindMask) == kBvhPacket) return boxes[top.leaves[index].first].id;
        return kBvhInner | std::uint32_t(bvh.nodes.size() + index);
    };
    for (BvhNode& node : top.nodes)
        for (std::uint32_t& child : node.child)
            child = resolve(child);
    bvh.root = resolve(top.root);
    bvh.bounds = top.bounds;
    bvh.nodes.insert(bvh.nodes.end(), top.nodes.begin(), top.nodes.end());
}

}  // namespace

Bvh build_bvh(std::span<const BvhMesh> meshes, std::span<const BvhInstance> instances) {
    const auto start = std::chrono::steady_clock::now();
    Plan plan = make_plan(meshes, instances);
    std::vector<MeshTree> trees(plan.trees.size());
    tbb::parallel_for(std::size_t(0), trees.size(),
                      [&](std::size_t t) { trees[t] = build_mesh_tree(std::move(plan.trees[t])); });

    Bvh bvh;
    append_trees(bvh, trees);
    for (const std::uint32_t i : plan.instances) {
        const WideTree& tree = trees[plan.tree_of_mesh[instances[i].mesh]].tree;
        if (tree.root != kBvhEmpty) bvh.instances.push_back(instance_ref(instances[i], i, tree));
    }
    HM_CHECK(bvh.instances.size() < ~kBvhKindMask, "{} instances", bvh.instances.size());
    if (bvh.instances.empty()) {
        bvh.root = trees[kStatic].tree.root;
        bvh.bounds = trees[kStatic].tree.bounds;
    } else {
        add_top_level(bvh, trees[kStatic].tree, instances);
    }

    for (const MeshTree& tree : trees) {
        bvh.stats.triangles += tree.boxes.size();
        bvh.stats.degenerate_triangles += tree.degenerate;
    }
    bvh.stats.nodes = bvh.nodes.size();
    bvh.stats.packets = bvh.packets.size();
    bvh.stats.merged_instances = plan.merged;
    bvh.stats.bytes = bvh.nodes.size() * sizeof(BvhNode) + bvh.packets.size() * sizeof(BvhPacket) +
                      bvh.ids.size() * sizeof(BvhTriangleId) +
                      bvh.instances.size() * sizeof(BvhInstanceRef);
    bvh.stats.build_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return bvh;
}

}  // namespace hm
