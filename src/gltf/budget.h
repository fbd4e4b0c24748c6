// Taking from the loader's budget before memory is: a small file can ask for very much.
#pragma once

#include <cstdint>

#include "gltf/json.h"
#include "gltf/source.h"

namespace hm::gltf {

// For decoding, whether or not the result is kept. Errors are at `json`.
Result<void> take_work(const Json& json, Source& source, std::uint64_t bytes);

// For what the scene keeps.
Result<void> take_memory(const Json& json, Source& source, std::uint64_t bytes);

}  // namespace hm::gltf
