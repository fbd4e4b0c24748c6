// A whole JSON document: parsed, and searched for what may stand anywhere in it.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "gltf/json.h"

namespace hm::gltf {

// Nesting allowed in a file. Real ones stay below 20; `extras` may hold anything.
inline constexpr std::size_t kMaxJsonDepth = 256;

// How many objects have each extension. What stands in `extras` is left out.
using ExtensionUses = std::map<std::string_view, std::size_t>;

struct Document {
    Json root;
    ExtensionUses extension_uses;
};

// Parses a whole document; its root must be an object. Where enough bytes behind the text may be
// read, whatever they are, it need not be copied.
Result<Document> parse_json(simdjson::dom::parser& parser, std::span<const std::byte> text,
                            const std::string& file, std::size_t readable_behind = 0);

}  // namespace hm::gltf
