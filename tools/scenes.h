// The demo scenes, each written as NAME.glb with its default flags in NAME.json.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "gltf_writer.h"

namespace hm {

// Long flag names without dashes; files are relative to the scene.
using DefaultFlags = std::vector<std::pair<std::string, std::string>>;

Result<void> write_scene(const std::filesystem::path& folder, const std::string& name,
                         const GltfWriter& writer, const DefaultFlags& flags);

Result<void> write_cornell(const std::filesystem::path& folder);
Result<void> write_spheres(const std::filesystem::path& folder);
Result<void> write_hero(const std::filesystem::path& folder);

}  // namespace hm
