// Every glTF file of a folder of real ones: it loads, or is refused for an extension it requires.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>

#include "gltf/load.h"

namespace hm {
namespace {

namespace fs = std::filesystem;

fs::path assets_folder() {
    if (const char* folder = std::getenv("HIMALAYA_ASSETS")) return folder;
    const char* source = std::getenv("HIMALAYA_SOURCE_DIR");
    return fs::path(source != nullptr ? source : ".") / "../shared/assets";
}

// Sorted, so that failures come in the same order everywhere.
std::set<fs::path> gltf_files(const fs::path& folder) {
    std::set<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path extension = entry.path().extension();
        if (extension == ".gltf" || extension == ".glb") files.insert(entry.path());
    }
    return files;
}

bool mentions(const fs::path& path, const std::string& text) {
    std::ifstream file(path, std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(file)), {});
    return content.find(text) != std::string::npos;
}

TEST(Corpus, LoadsOrIsRefusedForAnExtension) {
    if (!fs::is_directory(assets_folder())) GTEST_SKIP() << assets_folder() << " is absent";
    std::size_t loaded = 0, refused = 0;
    for (const fs::path& path : gltf_files(assets_folder())) {
        Diagnostics diagnostics;
        const auto scene = load_gltf(path, diagnostics);
        if (scene) {
            ++loaded;
            for (const Warning& warning : diagnostics.warnings())
                std::cout << warning.line() << '\n';
        } else {
            ++refused;
            std::cout << scene.error().line() << '\n';
            EXPECT_EQ(scene.error().code, ExitCode::unsupported) << scene.error().line();
            EXPECT_TRUE(mentions(path, "extensionsRequired")) << scene.error().line();
        }
    }
    std::cout << loaded << " loaded, " << refused << " refused\n";
    EXPECT_GT(loaded, refused);
}

}  // namespace
}  // namespace hm
