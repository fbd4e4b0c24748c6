// Morph targets (glTF 2.0, 3.7.2.2).
#pragma once

#include <cstdint>
#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// How many targets each primitive of the mesh has, which must be the same number.
Result<std::size_t> count_targets(const Json& mesh, const std::vector<Json>& primitives);

// A list of one number per target; empty where absent. `owner` is a mesh or a node.
Result<std::vector<float>> read_weights(const Json& owner, std::size_t target_count);

// The targets' deltas of the attributes that the primitive has. `kept` says which of the file's
// `count` vertices the primitive's are; empty: all of them.
Result<std::vector<MorphTarget>> read_targets(const Json& json, Source& source,
                                              const Primitive& primitive, std::uint32_t count,
                                              const std::vector<std::uint32_t>& kept);

}  // namespace hm::gltf
