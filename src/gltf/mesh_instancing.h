// EXT_mesh_gpu_instancing: one node that draws its mesh many times.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// Each instance's transform to the node's space, or nothing where the node has no such extension.
Result<std::vector<glm::mat4>> read_instances(const Json& node, Source& source);

}  // namespace hm::gltf
