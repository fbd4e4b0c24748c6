// A summary of a glTF file, read without its buffers and images; also works for files that
// load_gltf rejects.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace hm {

struct FileExtension {
    std::string name;
    bool required = false;
    bool supported = false;
};

// Lengths of the file's top-level arrays, whether or not the scene uses their elements.
struct FileCounts {
    std::size_t scenes = 0, nodes = 0, meshes = 0, materials = 0, textures = 0, images = 0;
    std::size_t cameras = 0, lights = 0, animations = 0, skins = 0;
    std::size_t accessors = 0, buffer_views = 0, buffers = 0;
};

struct FileSummary {
    bool binary = false;  // GLB
    std::size_t bytes = 0;
    std::string version, min_version, generator, copyright;
    std::vector<FileExtension> extensions;  // in the order of extensionsUsed, each once
    FileCounts counts;
    std::vector<std::string> scenes;    // names, empty if unnamed
    std::size_t scene = 0;              // index of the default scene
    std::vector<std::string> variants;  // of materials
};

// Fails if the file is unreadable, is not glTF, or has a top-level array of the wrong type.
Result<FileSummary> read_summary(const std::filesystem::path& path);

}  // namespace hm
