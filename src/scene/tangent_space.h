// Tangent spaces of a textured surface, the way that normal maps are baked against.
//
// The algorithm is MikkTSpace: M. S. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008),
// and the behaviour of its reference program, which glTF 2.0 (3.7.2.1) names as the default.
//  1. Corners with the same position, normal and texture coordinates are one vertex.
//  2. Each triangle has the directions in which u and v grow, and an orientation: whether the
//     texture lies on it as drawn or mirrored. Where the coordinates span no area it has none.
//  3. Around a vertex, triangles joined by edges and of one orientation form a group. A triangle
//     without an orientation takes that of the first group to reach it, and adds nothing to it.
//  4. A group's tangent at the vertex is the mean of its triangles' u directions, each projected
//     onto the normal's plane and weighted by the triangle's angle at the vertex there.
//  5. Triangles without extent copy what another corner of the same vertex got.
// The angular threshold is 180 degrees: only directions exactly opposed are kept apart.
#pragma once

#include <span>
#include <vector>

#include "scene/welding.h"

namespace hm {

// For corner i of triangle t, at 3t + i: a unit tangent along growing u, and in w the sign for
// glTF's bitangent cross(normal, tangent) * w, which points against growing v. Corners to which the
// texture gives no direction have (1, 0, 0, 1). Fewer than 2^32 / 3 triangles. In time linear but
// for sorting, whatever the mesh; always finite.
std::vector<vec4> corner_tangents(std::span<const SurfacePoint> points,
                                  std::span<const uvec3> triangles);

}  // namespace hm
