// glTF 2.0 -> Scene. The only module that sees a JSON parser.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/scene.h"

namespace hm {

struct LoadOptions {
    std::string scene;    // name or index, a name first; empty: the one the file names
    std::string variant;  // of materials (KHR_materials_variants); empty: none
    // Bytes that the file and what becomes of it may take together. 0: the lesser of 16 GiB and
    // three quarters of the available memory.
    std::uint64_t memory_limit = 0;
    // Buffers and images may lie anywhere on this machine, not only below the file's folder.
    bool allow_external = false;
};

// Reads a .glb or .gltf file (told by content), its buffers and images (embedded, beside the file
// or as data URIs). Every error carries the JSON pointer of the offending value. Codes: unreadable
// (a file is missing), invalid (a rule of the format is broken), unsupported (extensionsRequired).
// What the specification lets a renderer tolerate goes to `diagnostics`. An unknown scene or
// variant is ErrorKind::invalid_argument. What would pass the memory limit is refused before it is
// taken.
Result<Scene> load_gltf(const std::filesystem::path& path, Diagnostics& diagnostics,
                        const LoadOptions& options = {});

// The same for a file's bytes already in memory; `path` is for messages, and what the file names
// is looked for beside it.
Result<Scene> load_gltf_bytes(std::span<const std::byte> bytes, const std::filesystem::path& path,
                              Diagnostics& diagnostics, const LoadOptions& options = {});

}  // namespace hm
