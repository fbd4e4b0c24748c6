// Gives meshes the tangents that their normal maps need, where the file brings none.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace hm {

// Fills the primitive's tangents (see scene/tangent_space) from texture coordinates `uv_set`, and
// sets has_tangents. Without normals the faces' own are used. A vertex that two corners need with
// different tangents is split: the copies come after all that were there. Returns, for each vertex
// now, the one that it was.
std::vector<std::uint32_t> generate_tangents(Primitive& primitive, std::uint32_t uv_set);

// Does so for every primitive whose material maps normals; deformations, whose rest vertices are
// the primitive's, follow. A scene must have been through this before it is posed and flattened.
void prepare_tangents(Scene& scene);

}  // namespace hm
