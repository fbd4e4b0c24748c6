// Skinning attributes: JOINTS_n and WEIGHTS_n (glTF 2.0, 3.7.3.3).
#pragma once

#include <cstdint>
#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// Fills influences, joints and weights, normalized to a sum of one; does nothing if the primitive
// has no joints. `count` and `kept` are those of read_targets.
Result<void> read_influences(const Json& primitive, Source& source, std::uint32_t count,
                             const std::vector<std::uint32_t>& kept, Deformation& out);

}  // namespace hm::gltf
