// The data that traversal reads, as plain arrays that translation units for different instruction
// sets can share, and its input ray and output hit. Bvh (bvh/bvh.h) owns the memory.
#pragma once

#include <cstdint>

#include "shading/lang.h"

namespace hm {

struct Ray {
    vec3 origin;
    vec3 direction;  // length between 1e-18 and 1e18; t is in units of it
    float t_max;     // hits have 0 < t < t_max
};

struct Hit {
    float t;
    float u, v;  // barycentric weights of the triangle's second and third vertices
    std::uint32_t instance, geometry, primitive;
};

// References to a node's child or a tree's root: the upper two bits are the kind.
inline constexpr std::uint32_t kBvhInner = 0u << 30;     // index into nodes
inline constexpr std::uint32_t kBvhPacket = 2u << 30;    // index into packets
inline constexpr std::uint32_t kBvhInstance = 3u << 30;  // index into instances
inline constexpr std::uint32_t kBvhKindMask = 3u << 30;
inline constexpr std::uint32_t kBvhEmpty = 0xffffffffu;  // as a root: no triangles

inline constexpr std::uint32_t kBvhWidth = 8;
// Maximum number of node levels in one tree, which the builder guarantees. A visited node leaves at
// most seven siblings on the stack, so two nested trees and a marker between them need
// kBvhStackSize entries. The last eight allow a whole vector to be stored at the top.
inline constexpr std::uint32_t kBvhMaxDepth = 64;
inline constexpr std::uint32_t kBvhStackSize =
    2 * ((kBvhWidth - 1) * kBvhMaxDepth + 1) + 1 + kBvhWidth;

// The bounding boxes of eight children. bounds[2 * axis] are the lower planes,
// bounds[2 * axis + 1] the upper ones. Unused children have lower = +inf and upper = -inf, which no
// ray enters.
struct alignas(64) BvhNode {
    float bounds[6][kBvhWidth];
    std::uint32_t child[kBvhWidth];
};

// A leaf: one to eight triangles; unused lanes repeat the first.
struct alignas(64) BvhPacket {
    float position[3][3][kBvhWidth];  // [vertex][axis][lane]
    std::uint32_t used;               // bit per lane
    std::uint32_t non_opaque;         // bit per lane
};

// Lane l of packet p has its id at ids[8 * p + l]. In the tree of a shared mesh `instance` is
// unused.
struct BvhTriangleId {
    std::uint32_t instance, geometry, primitive;
};

struct BvhBounds {
    float lo[3], hi[3];
};

struct BvhInstanceRef {
    float world_to_object[4][3];  // columns
    BvhBounds bounds;             // of the mesh, in object space
    std::uint32_t root;
    std::uint32_t instance;
};

struct BvhView {
    const BvhNode* nodes;
    const BvhPacket* packets;
    const BvhTriangleId* ids;
    const BvhInstanceRef* instances;
    BvhBounds bounds;  // world space
    std::uint32_t root;
};

}  // namespace hm
