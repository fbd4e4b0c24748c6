// Skins (glTF 2.0, 3.7.3.1) and the nodes that wear them.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// One scene skin per skin of the file, in its order. `scene_node` has the scene's index of each of
// the file's nodes, or kUnset.
Result<std::vector<Skin>> read_skins(const Json& root, Source& source,
                                     const std::vector<int>& scene_node, const Scene& scene);

// Every mesh that a node draws with a skin has joints, and the skin has as many as it needs, all in
// the scene that is shown. `scene.skins` are there already.
Result<void> check_skinned_nodes(const Source& source, const std::vector<int>& scene_node,
                                 const Scene& scene);

}  // namespace hm::gltf
