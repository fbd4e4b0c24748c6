// Which vertices are one, and which triangles share an edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shading/structs.h"

namespace hm {

// What makes two corners of a mesh the same vertex of a surface with texture coordinates.
struct SurfacePoint {
    vec3 position;
    vec3 normal;
    vec2 uv;
};

// For each point the first that equals it exactly (zero has no sign).
std::vector<std::uint32_t> weld(std::span<const SurfacePoint> points);

// The edge beside each edge, or kNone. Edge 3t + i of triangle t leads from its corner i to the
// next. Neighbours run in opposite directions between the same two vertices (below vertex_count);
// where more than two triangles meet, they are paired in the order in which they come. Triangles in
// `left_out` have no neighbours; all others have three different vertices.
std::vector<std::uint32_t> pair_edges(std::span<const uvec3> triangles,
                                      const std::vector<bool>& left_out, std::size_t vertex_count);

}  // namespace hm
