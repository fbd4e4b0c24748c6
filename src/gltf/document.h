// The JSON of a glTF file.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "base/json_document.h"
#include "gltf/json.h"

namespace hm::gltf {

// Parses the JSON; its root must be an object, and so must the extensions of every object that a
// getter returns. key_counts() says how many objects have each extension, `extras` left out.
Result<JsonDocument> parse_document(std::span<const std::byte> text, const std::string& file,
                                    std::size_t readable_behind = 0);

}  // namespace hm::gltf
