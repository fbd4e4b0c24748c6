// Generates the tangents that normal maps need, for meshes whose file has none.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace hm {

// Fills the primitive's tangents (see scene/tangent_space) from texture coordinates `uv_set`, and
// sets has_tangents. Without normals, face normals are used. A vertex whose corners need different
// tangents is split: copies are appended after the existing vertices. Returns the original vertex
// index of each resulting vertex.
std::vector<std::uint32_t> generate_tangents(Primitive& primitive, std::uint32_t uv_set);

// Does this for every primitive whose material has a normal map. Deformations, whose rest vertices
// are those of the primitive, are updated too. Must be called before posing and flattening a scene.
void prepare_tangents(Scene& scene);

}  // namespace hm
