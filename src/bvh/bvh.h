// The CPU's acceleration structure: two levels (meshes, instances), binary trees built with binned
// SAH and collapsed to eight-wide nodes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shading/structs.h"

namespace hm {

struct BvhGeometry {
    std::span<const Vertex> vertices;
    std::span<const uvec3> triangles;
    bool opaque = true;  // else hits are offered to the any-hit callback
};

struct BvhMesh {
    std::vector<BvhGeometry> geometries;
};

struct BvhInstance {
    std::uint32_t mesh = 0;
    mat4x3 object_to_world;
    mat4x3 world_to_object;
};

struct BvhStats {
    std::uint64_t triangles = 0;             // unique, kept
    std::uint64_t degenerate_triangles = 0;  // zero area or not finite: left out
    std::uint64_t nodes = 0;
    std::uint64_t bytes = 0;
    double build_seconds = 0;
};

// Ray, Hit: what traversal takes and gives (bvh/traverse.h).
struct Ray {
    vec3 origin;
    vec3 direction;  // any length; t is in its units
    float t_max;
};

struct Hit {
    float t;
    float u, v;  // barycentric weights of the triangle's second and third vertex
    std::uint32_t instance, geometry, primitive;
};

}  // namespace hm
