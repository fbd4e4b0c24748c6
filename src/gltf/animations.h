// Animations (glTF 2.0, 3.11).
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// One scene animation per animation of the file, in its order; channels whose node is not in the
// scene that is shown are left out. `scene_node` has the scene's index of each of the file's nodes,
// or kUnset; the nodes are there already.
Result<std::vector<Animation>> read_animations(const Json& root, Source& source,
                                               const std::vector<int>& scene_node,
                                               const Scene& scene);

}  // namespace hm::gltf
