#include "support/asset_files.h"

#include <algorithm>
#include <cstdlib>

namespace hm::test {

namespace fs = std::filesystem;

fs::path source_folder() {
    const char* source = std::getenv("HIMALAYA_SOURCE_DIR");
    return source != nullptr ? source : ".";
}

fs::path assets_folder() {
    const char* assets = std::getenv("HIMALAYA_ASSETS");
    return assets != nullptr ? fs::path(assets) : source_folder() / "../shared/assets";
}

std::vector<fs::path> gltf_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path extension = entry.path().extension();
        if (extension == ".gltf" || extension == ".glb") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace hm::test
