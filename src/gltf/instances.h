// Copies of meshes that several nodes deform differently.
#pragma once

#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// Whether the mesh has morph targets or skinning attributes.
bool is_deformable(const Mesh& mesh);

// Gives each node that poses its mesh differently from the others (by a skin, its own weights or
// animated weights) a copy of that mesh. Nodes with the same pose keep sharing one.
Result<void> separate_posed_meshes(Source& source, Scene& scene);

}  // namespace hm::gltf
