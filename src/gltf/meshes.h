// Meshes (glTF 2.0, 3.7.2): every primitive that makes triangles, as an indexed triangle list.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// One scene mesh per mesh of the file, in its order, at rest.
Result<std::vector<Mesh>> read_meshes(const Json& root, Source& source,
                                      const std::vector<Material>& materials);

}  // namespace hm::gltf
