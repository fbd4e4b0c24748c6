// Morph targets (glTF 2.0, 3.7.2.2).
#pragma once

#include <cstdint>
#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// The number of targets, which must be the same for all primitives of the mesh.
Result<std::size_t> count_targets(const Json& mesh, const std::vector<Json>& primitives);

// One number per target; empty if absent. `owner` is a mesh or a node.
Result<std::vector<float>> read_weights(const Json& owner, std::size_t target_count);

// The targets' deltas of the attributes that the primitive has. `kept` lists which of the file's
// `count` vertices the primitive uses; empty: all.
Result<std::vector<MorphTarget>> read_targets(const Json& json, Source& source,
                                              const Primitive& primitive, std::uint32_t count,
                                              const std::vector<std::uint32_t>& kept);

}  // namespace hm::gltf
