// The node hierarchy (glTF 2.0, 3.5) of the chosen scene.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// Fills scene.nodes; scene's meshes, cameras and lights must be filled. Nesting may be of any
// depth. Returns the scene's index of each of the file's nodes, or kUnset.
Result<std::vector<int>> read_nodes(const Json& root, Source& source, Scene& scene);

}  // namespace hm::gltf
