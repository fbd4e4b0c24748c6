// GLB, the binary container (glTF 2.0, chapter 4), or plain JSON, detected by the first bytes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "base/diagnostics.h"
#include "base/result.h"

namespace hm::gltf {

struct Container {
    std::span<const std::byte> json;
    std::optional<std::span<const std::byte>> binary;  // GLB's BIN chunk
};

// Views into `bytes`, which must outlive them. Error::location is a byte offset.
Result<Container> split_container(std::span<const std::byte> bytes, const std::string& file,
                                  Diagnostics& diagnostics);

}  // namespace hm::gltf
