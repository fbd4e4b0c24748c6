// Real glTF files that tests read: the repository's own scenes, and a folder of others' where there
// is one (docs/testing.md, "Files that the tests read").
#pragma once

#include <filesystem>
#include <vector>

namespace hm::test {

// The repository.
std::filesystem::path source_folder();

// $HIMALAYA_ASSETS, or ../shared/assets beside the repository; may not exist.
std::filesystem::path assets_folder();

// Every .gltf and .glb file below a folder, sorted, so that failures come in the same order
// everywhere.
std::vector<std::filesystem::path> gltf_files(const std::filesystem::path& folder);

}  // namespace hm::test
