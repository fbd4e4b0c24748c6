// Meshes (glTF 2.0, 3.7.2): all primitives of triangles, as indexed triangle lists.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// One scene mesh per mesh of the file, in file order, in its rest pose.
Result<std::vector<Mesh>> read_meshes(const Json& root, Source& source,
                                      const std::vector<Material>& materials);

}  // namespace hm::gltf
