// Generates the tangents that normal maps need, for meshes whose file has none.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace hm {

// Fills the primitive's tangents (see scene/tangent_space) from the texture coordinates of the
// normal map's slot, transformed as the slot says, and sets has_tangents. Without normals, face
// normals are used. A vertex whose corners need different tangents is split: copies are appended
// after the existing vertices. Returns the original vertex index of each resulting vertex.
std::vector<std::uint32_t> generate_tangents(Primitive& primitive, const TextureSlot& slot);

// Does this for every primitive whose material has a normal map. Deformations, whose rest vertices
// are those of the primitive, are updated too. Must be called before posing and flattening a scene.
void prepare_tangents(Scene& scene);

}  // namespace hm
