// Compares our tangents with those in files that MikkTSpace generated from the stored triangles.
// (Blender's files are not suitable: it computes tangents before it splits quads into triangles,
// and the reference implementation disagrees with them just as much.)
#include <gtest/gtest.h>

#include <filesystem>

#include "gltf/load.h"
#include "scene/tangents.h"
#include "support/asset_files.h"

namespace hm {
namespace {

namespace fs = std::filesystem;

struct Agreement {
    std::size_t corners = 0, directions = 0, signs = 0;

    void compare(const Primitive& brought, const TextureSlot& slot) {
        Primitive made = brought;
        made.has_tangents = false;
        generate_tangents(made, slot);
        for (std::size_t t = 0; t < made.triangles.size(); ++t)
            for (int i = 0; i < 3; ++i) {
                const vec4 a = brought.vertices[brought.triangles[t][i]].tangent;
                const vec4 b = made.vertices[made.triangles[t][i]].tangent;
                ++corners;
                directions += dot(vec3(a), vec3(b)) > 0.9999f ? 1 : 0;
                signs += a.w == b.w ? 1 : 0;
            }
    }
};

TEST(TangentFiles, BringWhatWeMake) {
    const fs::path folder = test::assets_folder() / "khronos";
    if (!fs::is_directory(folder)) GTEST_SKIP() << folder << " is absent";
    for (const char* name : {"NormalTangentTest.glb", "ClearCoatTest.glb"}) {
        Diagnostics diagnostics;
        const Result<Scene> scene = load_gltf(folder / name, diagnostics);
        ASSERT_TRUE(scene) << scene.error().line();
        Agreement agreement;
        for (const Mesh& mesh : scene->meshes)
            for (const Primitive& p : mesh.primitives)
                if (p.has_tangents && p.material != kUnset)
                    agreement.compare(p, scene->materials[std::size_t(p.material)].normal_texture);
        EXPECT_GT(agreement.corners, 20000u) << name;
        EXPECT_GE(double(agreement.directions), 0.999 * double(agreement.corners)) << name;
        EXPECT_EQ(agreement.signs, agreement.corners) << name;
    }
}

}  // namespace
}  // namespace hm
