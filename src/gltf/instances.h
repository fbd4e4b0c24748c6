// Meshes that nodes deform in ways of their own.
#pragma once

#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// Whether morph targets or a skin move any of its vertices.
bool is_deformable(const Mesh& mesh);

// Gives each node that poses its mesh unlike the others (by a skin, by its own or by animated
// weights) a copy of that mesh. Nodes that pose it alike go on sharing one.
Result<void> separate_posed_meshes(Source& source, Scene& scene);

}  // namespace hm::gltf
