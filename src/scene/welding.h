// Welding: finds identical vertices, and triangles that share an edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shading/structs.h"

namespace hm {

// Vertex attributes; corners of a textured mesh are the same vertex if all of them are equal.
struct SurfacePoint {
    vec3 position;
    vec3 normal;
    vec2 uv;
};

// For each point, the index of the first point exactly equal to it (-0 equals 0).
std::vector<std::uint32_t> weld(std::span<const SurfacePoint> points);

// For each edge its neighbouring edge, or kNone. Edge 3t + i of triangle t runs from its corner i
// to the next. Neighbours run in opposite directions between the same two vertices (below
// vertex_count); where more than two triangles meet, they are paired in index order. Triangles in
// `left_out` have no neighbours; all others must have three distinct vertices.
std::vector<std::uint32_t> pair_edges(std::span<const uvec3> triangles,
                                      const std::vector<bool>& left_out, std::size_t vertex_count);

}  // namespace hm
