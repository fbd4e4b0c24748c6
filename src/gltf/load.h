// glTF 2.0 -> Scene. The only module that sees a JSON parser.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/scene.h"

namespace hm {

// Reads a .glb or .gltf file (told by content), its buffers and images (embedded, beside the file
// or as data URIs). Every error carries the JSON pointer of the offending value. Codes: unreadable
// (a file is missing), invalid (a rule of the format is broken), unsupported (extensionsRequired).
// What the specification lets a renderer tolerate goes to `diagnostics`.
Result<Scene> load_gltf(const std::filesystem::path& path, Diagnostics& diagnostics);

// The same for a file's bytes already in memory; `path` is for messages, and what the file names
// is looked for beside it.
Result<Scene> load_gltf_bytes(std::span<const std::byte> bytes, const std::filesystem::path& path,
                              Diagnostics& diagnostics);

}  // namespace hm
