// KHR_animation_pointer: which property of the scene a channel's JSON pointer means.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "gltf/json.h"
#include "scene/animation.h"

namespace hm::gltf {

struct PointedProperty {
    // Nothing: it exists, but changes no picture.
    std::variant<std::monostate, AnimatedProperty, AnimatedValue> what;
    std::size_t owner = 0;  // the file's number of the node, material, light or camera
};

// `target` is a channel's. Nothing where the property is not one that this program animates. Fails
// where the pointer leads to nothing in the file.
Result<std::optional<PointedProperty>> read_pointer(const Json& root, const Json& target);

}  // namespace hm::gltf
