// The node hierarchy (glTF 2.0, 3.5) of the scene that is shown.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// Fills scene.nodes; meshes, cameras and lights are there already. Any depth of nesting is fine.
// Returns the scene's index of each of the file's nodes, or kUnset.
Result<std::vector<int>> read_nodes(const Json& root, Source& source, Scene& scene);

}  // namespace hm::gltf
