// Every glTF file of a folder of real ones: it loads and renders, or is refused for an extension it
// requires.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>

#include "gltf/load.h"
#include "scene/camera.h"
#include "support/pictures.h"

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

// The whole path from the scene to radiance. Under the sanitizers that is the point; without them,
// that what comes out are numbers.
void render(Scene scene, const fs::path& path) {
    const EnvironmentMap environment = make_environment(default_environment(), 0, 1);
    test::Studio studio(std::move(scene), environment, {}, 2);
    const CameraData camera = camera_framing(studio.flat().bounds, 0.8f, 4.0f / 3);
    const test::Picture picture =
        studio.render(camera, {.width = 24, .height = 18, .samples = 2, .bounces = 3});
    for (const vec3& pixel : picture.pixels)
        ASSERT_TRUE(pixel.x >= 0 && pixel.y >= 0 && pixel.z >= 0 &&
                    std::isfinite(pixel.x + pixel.y + pixel.z))
            << path;
}

TEST(Assets, RenderOrAreRefusedForAnExtension) {
    if (!fs::is_directory(assets_folder())) GTEST_SKIP() << assets_folder() << " is absent";
    std::size_t loaded = 0, refused = 0;
    for (const fs::path& path : gltf_files(assets_folder())) {
        Diagnostics diagnostics;
        auto scene = load_gltf(path, diagnostics);
        if (scene) {
            ++loaded;
            for (const Warning& warning : diagnostics.warnings())
                std::cout << warning.line() << '\n';
            render(std::move(*scene), path);
        } else {
            ++refused;
            std::cout << scene.error().line() << '\n';
            EXPECT_EQ(scene.error().code, ExitCode::unsupported) << scene.error().line();
            EXPECT_TRUE(mentions(path, "extensionsRequired")) << scene.error().line();
        }
    }
    std::cout << loaded << " rendered, " << refused << " refused\n";
    EXPECT_GT(loaded, refused);
}

}  // namespace
}  // namespace hm
