// EXT_mesh_gpu_instancing: many instances of one node's mesh.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// The transforms from the instances' spaces to the node's; empty if the node has no such extension.
Result<std::vector<glm::mat4>> read_instances(const Json& node, Source& source);

}  // namespace hm::gltf
