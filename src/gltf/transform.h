// A node's own transform, in double precision.
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
std::optional<glm::dmat4> affine_matrix(std::span<const double, 16> columns);

}  // namespace hm::gltf
