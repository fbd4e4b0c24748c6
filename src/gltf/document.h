// The JSON of a glTF file.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "base/json_document.h"
#include "gltf/json.h"

namespace hm::gltf {

// Parses the JSON. The root must be an object, and so must the extensions of every object that a
// getter returns. key_counts() has the number of objects per extension, not counting those in
// `extras`.
Result<JsonDocument> parse_document(std::span<const std::byte> text, const std::string& file,
                                    std::size_t readable_behind = 0);

}  // namespace hm::gltf
