// A node's own transform.
#pragma once

#include <optional>
#include <span>

#include "gltf/json.h"
#include "scene/scene.h"

namespace hm::gltf {

// Sets `local` from `matrix`, or `rest` and `local` from translation, rotation and scale; the
// identity where the node has neither.
Result<void> read_transform(const Json& json, Node& node);

// Sixteen numbers, column by column. Nothing unless the last row is 0 0 0 1, to rounding.
std::optional<glm::mat4> affine_matrix(std::span<const float, 16> columns);

}  // namespace hm::gltf
