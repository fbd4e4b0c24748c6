// KHR_animation_pointer: resolves a channel's JSON pointer to a property of the scene.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "gltf/json.h"
#include "scene/animation.h"

namespace hm::gltf {

// std::monostate: the property exists, but does not affect the picture.
using Pointed = std::variant<std::monostate, AnimatedProperty, AnimatedValue>;

struct PointedProperty {
    Pointed what;
    std::size_t owner = 0;  // index of the node, material, light or camera in the file
};

class PointerReader {
  public:
    explicit PointerReader(const Json& root) : root_(root) {}

    // `target` is the channel's target object. Returns nullopt if the pointer refers to nothing in
    // the file or to a property that cannot be animated here. Fails if the JSON is invalid.
    Result<std::optional<PointedProperty>> read(const Json& target);

  private:
    Result<bool> target_exists(std::string_view table, std::size_t owner, std::string_view rest);

    const Json& root_;
    std::map<std::string, std::vector<Json>, std::less<>>
        tables_;  // those read so far, by JSON pointer
};

}  // namespace hm::gltf
