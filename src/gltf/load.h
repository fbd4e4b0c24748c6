// Loads glTF 2.0 files into a Scene.
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
    std::string scene;    // name or index, names first; empty: the file's default
    std::string variant;  // of materials (KHR_materials_variants); empty: none
    // Bytes that the file and the scene may take together. 0: the lesser of 16 GiB and three
    // quarters of the available memory.
    std::uint64_t memory_limit = 0;
    // Allow buffers and images anywhere on this machine, not only below the file's folder.
    bool allow_external = false;
};

// Reads a .glb or .gltf file (detected by content), its buffers and images (embedded, external
// files or data URIs). Errors carry the JSON pointer of the offending value. Kinds: unreadable (a
// file is missing), invalid (the file violates the format), unsupported (extensionsRequired),
// invalid_argument (unknown scene or variant). Faults that the specification lets a renderer
// tolerate go to `diagnostics`. The memory limit is checked before memory is allocated.
Result<Scene> load_gltf(const std::filesystem::path& path, Diagnostics& diagnostics,
                        const LoadOptions& options = {});

// The same for a file already in memory. `path` is used in messages, and its folder is the base of
// relative URIs.
Result<Scene> load_gltf_bytes(std::span<const std::byte> bytes, const std::filesystem::path& path,
                              Diagnostics& diagnostics, const LoadOptions& options = {});

}  // namespace hm
