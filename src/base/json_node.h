// The JSON parser's type of a value. Included by base/json*.cpp only, so that nothing else depends
// on the parser.
#pragma once

#include <simdjson.h>

#include <bit>
#include <type_traits>

#include "base/json.h"

namespace hm {

static_assert(std::is_trivially_copyable_v<simdjson::dom::element>);

inline simdjson::dom::element to_element(JsonNode node) {
    return std::bit_cast<simdjson::dom::element>(node);
}

inline JsonNode to_node(simdjson::dom::element value) {
    return std::bit_cast<JsonNode>(value);
}

}  // namespace hm
