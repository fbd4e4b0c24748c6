// A node's own transform.
#pragma once

#include "gltf/json.h"
#include "scene/scene.h"

namespace hm::gltf {

// `matrix` or translation * rotation * scale; the identity where the node has neither.
Result<glm::mat4> read_transform(const Json& node);

}  // namespace hm::gltf
