// A node's local transform, in double precision.
#pragma once

#include <optional>
#include <span>

#include "gltf/json.h"
#include "scene/scene.h"

namespace hm::gltf {

// Sets `local` from `matrix`, or `rest` and `local` from translation, rotation and scale. The
// default is the identity.
Result<void> read_transform(const Json& json, Node& node);

// From 16 numbers in column-major order. nullopt unless the last row is 0 0 0 1 up to rounding.
std::optional<glm::dmat4> affine_matrix(std::span<const double, 16> columns);

}  // namespace hm::gltf
