// KHR_animation_pointer: which property of the scene a channel's JSON pointer means.
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

// std::monostate: the property exists, but changes no picture.
using Pointed = std::variant<std::monostate, AnimatedProperty, AnimatedValue>;

struct PointedProperty {
    Pointed what;
    std::size_t owner = 0;  // the file's number of the node, material, light or camera
};

class PointerReader {
  public:
    explicit PointerReader(const Json& root) : root_(root) {}

    // `target` is a channel's. Nothing where the property is not one that this program animates.
    // Fails if the pointer refers to nothing in the file.
    Result<std::optional<PointedProperty>> read(const Json& target);

  private:
    Result<bool> leads_somewhere(std::string_view table, std::size_t owner, std::string_view rest);

    const Json& root_;
    std::map<std::string, std::vector<Json>, std::less<>>
        tables_;  // those used so far, by their pointers
};

}  // namespace hm::gltf
