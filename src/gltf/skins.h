// Skins (glTF 2.0, 3.7.3.1) and checks of the nodes that use them.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// One scene skin per skin of the file, in file order. `scene_node` maps node indices of the file to
// those of the scene, or to kUnset.
Result<std::vector<Skin>> read_skins(const Json& root, Source& source,
                                     const std::vector<int>& scene_node, const Scene& scene);

// Fails if a skinned node's mesh has no joint attributes or uses joints that the skin does not
// have, or if a joint is outside the chosen scene. scene.skins must be filled.
Result<void> check_skinned_nodes(const Source& source, const std::vector<int>& scene_node,
                                 const Scene& scene);

}  // namespace hm::gltf
