// Taking from the loader's budget before memory is: a small file can ask for very much.
#pragma once

#include <cstdint>
#include <span>

#include "gltf/json.h"
#include "gltf/source.h"

namespace hm::gltf {

// Bytes that loading may take, from the options or the available memory.
std::uint64_t memory_limit(const LoadOptions& options);

// A budget that the file itself, of `file_bytes`, is taken from already.
Budget make_budget(std::uint64_t limit, std::uint64_t file_bytes);
// Each byte of input makes for as much work as a sane file has.
void add_work(Budget& budget, std::uint64_t input_bytes);

// What parsing this text may take.
std::uint64_t json_memory(std::span<const std::byte> text);

// For decoding, whether or not the result is kept. Errors are at `json`.
Result<void> take_work(const Json& json, Source& source, std::uint64_t bytes);

// For what stays in memory until loading ends.
Result<void> take_memory(const Json& json, Source& source, std::uint64_t bytes);

// Fails if it is more than the budget has left.
Result<void> check_memory(const Budget& budget, std::uint64_t bytes, const std::string& file,
                          const std::string& pointer);

}  // namespace hm::gltf
