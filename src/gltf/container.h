// GLB, the binary container (glTF 2.0, chapter 4), or plain JSON: told apart by the first bytes.
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

// The parts of `bytes`, which must outlive them. Errors' places are byte offsets.
Result<Container> split_container(std::span<const std::byte> bytes, const std::string& file,
                                  Diagnostics& diagnostics);

}  // namespace hm::gltf
