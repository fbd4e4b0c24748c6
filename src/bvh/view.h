// What traversal reads: plain arrays that a translation unit per instruction set can share, and the
// ray and hit that go in and out. Bvh (bvh/bvh.h) owns the memory.
#pragma once

#include <cstdint>

#include "shading/lang.h"

namespace hm {

struct Ray {
    vec3 origin;
    vec3 direction;  // any length between 1e-18 and 1e18; t is in its units
    float t_max;     // hits lie in 0 < t < t_max
};

struct Hit {
    float t;
    float u, v;  // barycentric weights of the triangle's second and third vertex
    std::uint32_t instance, geometry, primitive;
};

// References to what a node's child or a tree's root is: the upper two bits tell the kind.
inline constexpr std::uint32_t kBvhInner = 0u << 30;     // index into nodes
inline constexpr std::uint32_t kBvhPacket = 2u << 30;    // index into packets
inline constexpr std::uint32_t kBvhInstance = 3u << 30;  // index into instances
inline constexpr std::uint32_t kBvhKindMask = 3u << 30;
inline constexpr std::uint32_t kBvhEmpty = 0xffffffffu;  // as a root: no triangles at all

inline constexpr std::uint32_t kBvhWidth = 8;
// Levels of nodes in one tree; the builder keeps to it. A visited node leaves at most seven
// siblings on the stack, so two trees above each other and a mark between them need kBvhStackSize.
// The last eight let a whole vector be stored at the top.
inline constexpr std::uint32_t kBvhMaxDepth = 64;
inline constexpr std::uint32_t kBvhStackSize =
    2 * ((kBvhWidth - 1) * kBvhMaxDepth + 1) + 1 + kBvhWidth;

// Eight children's boxes. bounds[2 * axis] are the lower planes, bounds[2 * axis + 1] the upper.
// Unused children have lower = +inf, upper = -inf, which no ray enters.
struct alignas(64) BvhNode {
    float bounds[6][kBvhWidth];
    std::uint32_t child[kBvhWidth];
};

// A leaf: one to eight triangles, the unused lanes repeat the first.
struct alignas(64) BvhPacket {
    float position[3][3][kBvhWidth];  // [vertex][axis][lane]
    std::uint32_t used;               // bit per lane
    std::uint32_t non_opaque;         // bit per lane
};

// Of lane l of packet p at ids[8 * p + l]. In a mesh's own tree `instance` is unused.
struct BvhTriangleId {
    std::uint32_t instance, geometry, primitive;
};

struct BvhBounds {
    float lo[3], hi[3];
};

struct BvhInstanceRef {
    float world_to_object[4][3];  // columns
    BvhBounds bounds;             // of the mesh, object space
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
