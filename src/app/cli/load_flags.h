// The flags for reading a scene file, shared by all commands that read one.
#pragma once

#include "app/cli/cli11.h"
#include "app/cli/values.h"
#include "gltf/load.h"

namespace hm::cli {

// Bytes: a whole number, with K, M, G or T for powers of 1024. Not 0.
Parsed<std::uint64_t> parse_bytes(std::string_view text);

void add_load_flags(CLI::App& app, LoadOptions& options);

}  // namespace hm::cli
