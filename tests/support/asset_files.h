// Real glTF files that tests read: the repository's own scenes, and an optional folder of
// third-party assets (docs/testing.md, "Files that the tests read").
#pragma once

#include <filesystem>
#include <vector>

namespace hm::test {

// The repository root.
std::filesystem::path source_folder();

// $HIMALAYA_ASSETS, or ../shared/assets beside the repository; may not exist.
std::filesystem::path assets_folder();

// All .gltf and .glb files below a folder (recursive), sorted so that failures are reported in the
// same order everywhere.
std::vector<std::filesystem::path> gltf_files(const std::filesystem::path& folder);

}  // namespace hm::test
