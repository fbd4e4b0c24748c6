// Poses every animated file of a folder of real files at several times of each animation.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "gltf/load.h"
#include "scene/flatten.h"
#include "scene/pose.h"
#include "support/asset_files.h"

namespace hm {
namespace {

namespace fs = std::filesystem;

bool has_prefix(const std::string& name) {
    for (const char* prefix : {"01_cs_", "01_morphed", "03_", "06", "07"})
        if (name.starts_with(prefix)) return true;
    return false;
}

float last_time(const Animation& animation) {
    float last = 0;
    for (const AnimationSampler& sampler : animation.samplers)
        last = std::max(last, sampler.times.back());
    return last;
}

bool same_pose(const Scene& a, const Scene& b) {
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
        if (a.nodes[i].local != b.nodes[i].local) return false;
    for (std::size_t m = 0; m < a.meshes.size(); ++m)
        for (std::size_t p = 0; p < a.meshes[m].primitives.size(); ++p)
            for (std::size_t v = 0; v < a.meshes[m].primitives[p].vertices.size(); ++v)
                if (a.meshes[m].primitives[p].vertices[v].position !=
                    b.meshes[m].primitives[p].vertices[v].position)
                    return false;
    return true;
}

TEST(PosedCorpus, PosesAndComesBackToRest) {
    const fs::path folder = test::assets_folder() / "core";
    if (!fs::is_directory(folder)) GTEST_SKIP() << folder << " is absent";
    std::size_t animations = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!has_prefix(name)) continue;
        Diagnostics diagnostics;
        const auto loaded = load_gltf(entry.path() / (name + ".gltf"), diagnostics);
        ASSERT_TRUE(loaded) << loaded.error().line();
        Scene scene = *loaded;
        for (std::size_t i = 0; i < scene.animations.size(); ++i, ++animations) {
            bool moved = false;
            const double end = double(last_time(scene.animations[i]));
            for (const double share : {0.0, 0.3, 0.5, 1.0, 1.5}) {
                const auto posed = pose_scene(scene, PoseTime{{i}, share * end});
                ASSERT_TRUE(posed) << posed.error().line();
                moved = moved || !same_pose(scene, *loaded);
                EXPECT_FALSE(flatten(scene, {}, {}, diagnostics).bounds.empty()) << name;
            }
            EXPECT_TRUE(moved) << name << " " << scene.animations[i].name;
        }
        ASSERT_TRUE(pose_scene(scene, std::nullopt));
        EXPECT_TRUE(same_pose(scene, *loaded)) << name;
    }
    EXPECT_GE(animations, 15u);
}

}  // namespace
}  // namespace hm
