// Skins in files: influences, inverse bind matrices, skinned nodes, and rejected files.
#include "gltf/test_accessors.h"
#include "scene/pose.h"

namespace hm::gltf_test {
namespace {

std::string skinned_mesh(const std::string& influences) {
    return R"([{"primitives":[{"indices":3,"attributes":{"POSITION":0,"NORMAL":1,)" + influences +
           "}}]}]";
}

// Accessors 6 to 13.
struct Parts {
    Accessors all;
    Parts() {
        all.add<std::uint8_t>("VEC4", 5121, 3, {0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});   // 6
        all.floats("VEC4", 3, {0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0});              // 7
        all.add<std::uint16_t>("VEC4", 5123, 3, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});  // 8
        all.add<std::uint8_t>("VEC4", 5121, 3, {0, 0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0},
                              R"(,"normalized":true)");                          // 9
        all.floats("MAT4", 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,  // 10
                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -8, 0, 0, 1});
        all.floats("MAT4", 1, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});  // 11
        all.floats("VEC4", 3, {1, 0, 0, 0, 1, 0, 0, 0, 2, -1, 0, 0});             // 12
        all.floats("MAT4", 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1,    // 13
                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
        all.floats("VEC4", 3, {1, -6e-8f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});  // 14
    }
};

constexpr const char* kOneSet = R"("JOINTS_0":6,"WEIGHTS_0":7)";
constexpr const char* kNodes = R"([{"mesh":0,"skin":0,"translation":[50,0,0]},
    {"translation":[0,0,1],"children":[2]},{"translation":[8,0,4]}])";

Overrides file(const std::string& influences, const std::string& skins,
               const std::string& nodes = kNodes, const std::string& roots = "[0,1]") {
    return Parts().all.with({{"meshes", skinned_mesh(influences)},
                             {"skins", skins},
                             {"nodes", nodes},
                             {"scenes", "[{\"nodes\":" + roots + "}]"}});
}

vec3 position(const Loaded& loaded, std::size_t vertex, std::size_t mesh = 0) {
    return loaded.scene->meshes.at(mesh).primitives.at(0).vertices.at(vertex).position;
}

TEST(Skins, BindMatricesAndWeights) {
    const Loaded loaded =
        load_text(document(file(kOneSet, R"([{"joints":[1,2],"inverseBindMatrices":10}])")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    // The joints are at z = 1 and at (8, 0, 5); the second was bound at x = 8.
    EXPECT_EQ(position(loaded, 0), vec3(0, 0, 3));
    EXPECT_EQ(position(loaded, 1), vec3(1, 0, 5));
    EXPECT_EQ(position(loaded, 2), vec3(0, 2, 5));  // its weight of 3 is normalized to 1
    EXPECT_EQ(loaded.diagnostics.warnings().size(), 1u);
    EXPECT_EQ(loaded.warned("/meshes/0/primitives/0", "do not sum to one"), 1u);
}

TEST(Skins, WithoutBindMatricesAndWithTwoSets) {
    const Loaded loaded = load_text(document(
        file(R"("JOINTS_0":6,"WEIGHTS_0":7,"JOINTS_1":8,"WEIGHTS_1":9)", R"([{"joints":[1,2]}])")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(loaded.scene->meshes[0].primitives[0].deformation->influences, 8u);
    // Weight 0.5 for joint 1 at (8, 0, 5), 0.5 for joint 0 at z = 1.
    EXPECT_EQ(position(loaded, 1), vec3(5, 0, 3));
}

TEST(Skins, TwoSkinsOfOneMesh) {
    const Loaded loaded =
        load_text(document(file(kOneSet, R"([{"joints":[1,2]},{"joints":[2,1]}])",
                                R"([{"mesh":0,"skin":0},{"translation":[0,0,1],"children":[2]},
                 {"translation":[8,0,4]},{"mesh":0,"skin":1},{"mesh":0,"skin":0}])",
                                "[0,1,3,4]")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    ASSERT_EQ(loaded.scene->meshes.size(), 2u);
    EXPECT_EQ(position(loaded, 1, 0), vec3(9, 0, 5));
    EXPECT_EQ(position(loaded, 1, 1), vec3(1, 0, 1));
}

TEST(Skins, Refusals) {
    const std::string good = R"([{"joints":[1,2]}])";
    expect_refused({
        {"no weights", file(R"("JOINTS_0":6)", good), "/meshes/0/primitives/0/attributes/JOINTS_0",
         "without WEIGHTS_0"},
        {"no joints", file(R"("WEIGHTS_0":7)", good), "/meshes/0/primitives/0/attributes/WEIGHTS_0",
         "without JOINTS_0"},
        {"joints of floats", file(R"("JOINTS_0":7,"WEIGHTS_0":7)", good),
         "/meshes/0/primitives/0/attributes/JOINTS_0", "type"},
        {"weights of integers", file(R"("JOINTS_0":6,"WEIGHTS_0":6)", good),
         "/meshes/0/primitives/0/attributes/WEIGHTS_0", "type"},
        {"negative", file(R"("JOINTS_0":6,"WEIGHTS_0":12)", good), "/accessors/12", "negative"},
        {"too few joints", file(kOneSet, R"([{"joints":[1]}])"), "/nodes/0/skin",
         "uses joint 1, but the skin has only 1"},
        {"no influences", file(R"("TEXCOORD_0":2)", good), "/nodes/0/skin", "without JOINTS_0"},
        {"no joint", file(kOneSet, R"([{"joints":[]}])"), "/skins/0/joints", "at least one"},
        {"joint twice", file(kOneSet, R"([{"joints":[1,1]}])"), "/skins/0/joints/1", "is repeated"},
        {"no such joint", file(kOneSet, R"([{"joints":[1,3]}])"), "/skins/0/joints/1",
         "past the end"},
        {"no such skin", file(kOneSet, "[]"), "/nodes/0/skin", "past the end"},
        {"skin without mesh", file(kOneSet, good, R"([{"skin":0},{},{}])"), "/nodes/0/skin",
         "must have a mesh"},
        {"joint elsewhere", file(kOneSet, good, kNodes, "[0]"), "/nodes/0/skin",
         "not in the chosen scene"},
        {"few matrices", file(kOneSet, R"([{"joints":[1,2],"inverseBindMatrices":11}])"),
         "/skins/0/inverseBindMatrices", "1 elements for 2"},
        {"no matrices", file(kOneSet, R"([{"joints":[1,2],"inverseBindMatrices":7}])"),
         "/skins/0/inverseBindMatrices", "MAT4"},
        {"projection", file(kOneSet, R"([{"joints":[1,2],"inverseBindMatrices":13}])"),
         "/accessors/13", "last row"},
        {"no such skeleton", file(kOneSet, R"([{"joints":[1,2],"skeleton":9}])"),
         "/skins/0/skeleton", "past the end"},
    });
}

TEST(Skins, RoundedWeightsAreClamped) {
    const Loaded loaded =
        load_text(document(file(R"("JOINTS_0":6,"WEIGHTS_0":14)", R"([{"joints":[1,2]}])")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(loaded.warned("/accessors/14", "slightly below 0"), 1u);
    EXPECT_EQ(loaded.scene->meshes.at(0).primitives.at(0).deformation->weights.at(1), 0.0f);
}

TEST(Skins, OddHierarchiesAreDrawnWithAWarning) {
    const Loaded apart = load_text(document(
        file(kOneSet, R"([{"joints":[1,2]}])", R"([{"mesh":0,"skin":0},{},{}])", "[0,1,2]")));
    ASSERT_TRUE(apart.scene) << apart.scene.error().line();
    EXPECT_EQ(apart.warned("/skins/0/joints", "no common root"), 1u);
    const Loaded skeleton =
        load_text(document(file(kOneSet, R"([{"joints":[1,2],"skeleton":2}])")));
    ASSERT_TRUE(skeleton.scene) << skeleton.scene.error().line();
    EXPECT_EQ(skeleton.warned("/skins/0/skeleton", "not a common root"), 1u);
}

}  // namespace
}  // namespace hm::gltf_test
