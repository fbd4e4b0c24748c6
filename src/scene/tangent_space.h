// Tangent spaces of a textured surface, as used for baking normal maps.
//
// The algorithm is MikkTSpace: M. S. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008),
// and the behaviour of its reference implementation, which glTF 2.0 (3.7.2.1) specifies as default.
//  1. Corners with the same position, normal and texture coordinates are welded to one vertex.
//  2. Each triangle has the directions of increasing u and v, and an orientation: whether the
//     texture is mirrored on it or not. Triangles with zero UV area have no orientation.
//  3. Around a vertex, edge-connected triangles of the same orientation form a group. A triangle
//     without orientation takes that of the first group that reaches it, but contributes nothing.
//  4. A group's tangent at the vertex is the mean of its triangles' u directions, each projected
//     onto the plane of the normal and weighted by the triangle's angle at the vertex in that
//     plane.
//  5. Degenerate triangles copy the tangent of another corner of the same vertex.
// The angular threshold is 180 degrees: only exactly opposite directions are split.
#pragma once

#include <span>
#include <vector>

#include "scene/welding.h"

namespace hm {

// Element 3t + i is for corner i of triangle t: a unit tangent along increasing u, and in w the
// sign for glTF's bitangent cross(normal, tangent) * w, which points along decreasing v. Corners
// without a UV direction get (1, 0, 0, 1). Fewer than 2^32 / 3 triangles. Linear time except for
// sorting, for any mesh; the result is always finite.
std::vector<vec4> corner_tangents(std::span<const SurfacePoint> points,
                                  std::span<const uvec3> triangles);

}  // namespace hm
