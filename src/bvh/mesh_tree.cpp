#include "bvh/mesh_tree.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "base/check.h"
#include "shading/degenerate.h"

namespace hm {
namespace {

constexpr std::uint32_t kBlock = 1 << 15;  // triangles per task

struct Corners {
    vec3 at[3];
};

Corners corners_of(const TreePart& part, std::uint32_t primitive) {
    const uvec3 triangle = part.geometry->triangles[primitive];
    Corners corners;
    for (int i = 0; i < 3; ++i) {
        HM_CHECK(triangle[i] < part.geometry->vertices.size(), "vertex {} of {}", triangle[i],
                 part.geometry->vertices.size());
        const vec3 p = part.geometry->vertices[triangle[i]].position;
        if (part.object_to_world != nullptr) {
            const mat4x3& m = *part.object_to_world;
            corners.at[i] = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
        } else {
            corners.at[i] = p;
        }
    }
    return corners;
}

BvhBox box_of(const Corners& corners, std::uint32_t primitive, std::uint32_t part) {
    const vec3 lo = glm::min(glm::min(corners.at[0], corners.at[1]), corners.at[2]);
    const vec3 hi = glm::max(glm::max(corners.at[0], corners.at[1]), corners.at[2]);
    return {{lo.x, lo.y, lo.z}, primitive, {hi.x, hi.y, hi.z}, part};
}

// A range of one part's triangles and the offset at which its boxes are written.
struct Block {
    std::uint32_t part, first, count;
    std::size_t offset;
    std::uint32_t kept = 0;
};

std::vector<BvhBox> gather_boxes(std::span<const TreePart> parts, std::uint64_t& degenerate) {
    std::vector<Block> blocks;
    std::size_t total = 0;
    for (std::uint32_t p = 0; p < parts.size(); ++p) {
        const std::size_t count = parts[p].geometry->triangles.size();
        for (std::size_t first = 0; first < count; first += kBlock) {
            const auto size = std::uint32_t(std::min<std::size_t>(kBlock, count - first));
            blocks.push_back({p, std::uint32_t(first), size, total});
            total += size;
        }
    }
    HM_CHECK(total < 1u << 30, "{} triangles in one tree", total);

    std::vector<BvhBox> boxes(total);
    tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
        Block& block = blocks[b];
        for (std::uint32_t i = block.first; i < block.first + block.count; ++i) {
            const Corners corners = corners_of(parts[block.part], i);
            if (is_degenerate(corners.at[0], corners.at[1], corners.at[2])) continue;
            boxes[block.offset + block.kept++] = box_of(corners, i, block.part);
        }
    });
    std::size_t end = 0;
    for (const Block& block : blocks) {
        if (end != block.offset)
            std::copy_n(boxes.begin() + std::ptrdiff_t(block.offset), block.kept,
                        boxes.begin() + std::ptrdiff_t(end));
        end += block.kept;
    }
    degenerate = total - end;
    boxes.resize(end);
    return boxes;
}

}  // namespace

MeshTree build_mesh_tree(std::vector<TreePart> parts) {
    MeshTree result;
    result.parts = std::move(parts);
    result.boxes = gather_boxes(result.parts, result.degenerate);
    if (!result.boxes.empty()) result.tree = collapse(build_binary_tree(result.boxes), kBvhWidth);
    return result;
}

void write_packets(const MeshTree& tree, std::span<BvhPacket> packets,
                   std::span<BvhTriangleId> ids) {
    tbb::parallel_for(std::size_t(0), tree.tree.leaves.size(), [&](std::size_t l) {
        const WideLeaf leaf = tree.tree.leaves[l];
        BvhPacket& packet = packets[l];
        packet.used = (1u << leaf.count) - 1;
        packet.non_opaque = 0;
        for (std::uint32_t lane = 0; lane < kBvhWidth; ++lane) {
            const BvhBox& box = tree.boxes[leaf.first + (lane < leaf.count ? lane : 0)];
            const TreePart& part = tree.parts[box.part];
            const Corners corners = corners_of(part, box.id);
            for (int v = 0; v < 3; ++v)
                for (int a = 0; a < 3; ++a)
                    packet.position[v][a][lane] = corners.at[v][a];
            if (!part.geometry->opaque) packet.non_opaque |= 1u << lane;
            ids[kBvhWidth * l + lane] = {part.instance, part.geometry_index, box.id};
        }
    });
}

}  // namespace hm
