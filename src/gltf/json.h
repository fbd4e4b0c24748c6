// Properties that any glTF object may have.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/json.h"
#include "base/result.h"

namespace hm::gltf {

// The extension `name` of an object, if present.
Result<std::optional<Json>> extension_of(const Json& object, std::string_view name);

// The name of an object, empty if absent.
Result<std::string> name_of(const Json& object);

}  // namespace hm::gltf
