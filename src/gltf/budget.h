// The loader's memory and work budget, charged before anything is allocated: a small file can
// require a lot of memory.
#pragma once

#include <cstdint>
#include <span>

#include "gltf/json.h"
#include "gltf/source.h"

namespace hm::gltf {

// Memory limit for loading in bytes, from the options or the available memory.
std::uint64_t memory_limit(const LoadOptions& options);

// A budget from which the file itself, `file_bytes`, is already deducted.
Budget make_budget(std::uint64_t limit, std::uint64_t file_bytes);
// Raises the work limit in proportion to the size of further input.
void add_work(Budget& budget, std::uint64_t input_bytes);

// Upper bound of the memory for parsing this text, in bytes.
std::uint64_t json_memory(std::span<const std::byte> text);

// Charges decoding work, whether or not the result is kept. Errors are located at `json`.
Result<void> take_work(const Json& json, Source& source, std::uint64_t bytes);

// Charges memory that stays allocated until loading ends.
Result<void> take_memory(const Json& json, Source& source, std::uint64_t bytes);

// Fails if `bytes` exceed what is left of the memory budget.
Result<void> check_memory(const Budget& budget, std::uint64_t bytes, const std::string& file,
                          const std::string& pointer);

}  // namespace hm::gltf
