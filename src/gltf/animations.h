// Animations (glTF 2.0, 3.11).
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// One scene animation per animation of the file, in file order; channels of nodes outside the
// chosen scene are dropped. `scene_node` maps node indices of the file to those of the scene, or to
// kUnset. scene.nodes must be filled.
Result<std::vector<Animation>> read_animations(const Json& root, Source& source,
                                               const std::vector<int>& scene_node,
                                               const Scene& scene);

}  // namespace hm::gltf
