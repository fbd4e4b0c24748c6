// KHR_animation_pointer, also with KHR_node_visibility: animated values, restoring the rest pose,
// and rejected files.
#include <cmath>

#include "gltf/test_accessors.h"
#include "scene/pose.h"

namespace hm::gltf_test {
namespace {

std::string channel(std::size_t sampler, const std::string& pointer) {
    return fmt::format(
        R"({{"sampler":{},"target":{{"path":"pointer","extensions":{{"KHR_animation_pointer":
            {{"pointer":"{}"}}}}}}}})",
        sampler, pointer);
}

std::string animations(const std::string& channels, const std::string& samplers) {
    return fmt::format(R"([{{"channels":[{}],"samplers":[{}]}}])", channels, samplers);
}

std::string sampler(std::size_t input, std::size_t output, const char* interpolation = "LINEAR") {
    return fmt::format(R"({{"input":{},"output":{},"interpolation":"{}"}})", input, output,
                       interpolation);
}

// A scene with an object of every kind that pointers can refer to.
Overrides everything(const Accessors& more, const std::string& animations) {
    return more.with({
        {"materials", R"([{"pbrMetallicRoughness":{"metallicFactor":0.25},"emissiveFactor":[1,1,1],
            "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":3}}}])"},
        {"cameras", R"([{"type":"perspective","perspective":{"yfov":1,"znear":1}}])"},
        {"extensions", R"({"KHR_lights_punctual":{"lights":[{"type":"spot","spot":{}}]}})"},
        {"nodes", R"([{"mesh":0,"extensions":{"KHR_node_visibility":{"visible":true}}},
            {"camera":0},{"extensions":{"KHR_lights_punctual":{"light":0}}}])"},
        {"scenes", R"([{"nodes":[0,1,2]}])"},
        {"animations", animations},
    });
}

TEST(AnimationPointer, MovesFactorsLightsAndCameras) {
    Accessors more;
    const auto times = more.floats("SCALAR", 2, {0, 2});
    const auto unit = more.floats("SCALAR", 2, {0, 1});
    const auto color = more.floats("VEC4", 2, {0, 0, 0, 0, 1, 1, 1, 1});
    const auto triple = more.floats("VEC3", 2, {0, 0, 0, 1, 2, 4});
    const auto bytes =
        more.add<std::uint8_t>("SCALAR", 5121, 2, {0, 10});  // 0 and 10, not normalized
    const std::string pbr = "/materials/0/pbrMetallicRoughness/";
    const std::string light = "/extensions/KHR_lights_punctual/lights/0/";
    Loaded loaded = load_text(document(everything(
        more,
        animations(
            channel(0, pbr + "metallicFactor") + "," + channel(1, pbr + "baseColorFactor") + "," +
                channel(2, "/nodes/0/translation") + "," + channel(2, light + "color") + "," +
                channel(3, light + "intensity") + "," + channel(0, light + "spot/innerConeAngle") +
                "," + channel(0, "/cameras/0/perspective/yfov") + "," +
                channel(0, "/cameras/0/perspective/znear") + "," +
                channel(3,
                        "/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength"),
            sampler(times, unit) + "," + sampler(times, color) + "," + sampler(times, triple) +
                "," + sampler(times, bytes)))));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_TRUE(loaded.diagnostics.warnings().empty()) << loaded.diagnostics.warnings()[0].line();
    Scene& scene = *loaded.scene;
    EXPECT_EQ(scene.materials[0].metallic, 0.25f);  // the rest pose
    ASSERT_TRUE(pose_scene(scene, PoseTime{{0}, 1}));
    EXPECT_EQ(scene.materials[0].metallic, 0.5f);
    EXPECT_EQ(scene.materials[0].base_color, vec4(0.5f));
    EXPECT_EQ(scene.materials[0].emissive(), vec3(5));
    EXPECT_EQ(scene.nodes[0].local[3], glm::dvec4(0.5f, 1, 2, 1));
    EXPECT_EQ(scene.lights[0].color, vec3(0.5f, 1, 2));
    EXPECT_EQ(scene.lights[0].intensity, 5);
    EXPECT_EQ(scene.lights[0].inner_cone, 0.5f);
    EXPECT_EQ(scene.cameras[0].yfov, 0.5f);
    ASSERT_TRUE(pose_scene(scene, PoseTime{{0}, 0}));
    EXPECT_GT(scene.cameras[0].yfov, 0);  // clamped to the minimum field of view
    ASSERT_TRUE(pose_scene(scene, std::nullopt));
    EXPECT_EQ(scene.materials[0].metallic, 0.25f);
    EXPECT_EQ(scene.materials[0].emissive(), vec3(3));
    EXPECT_EQ(scene.nodes[0].local[3], glm::dvec4(0, 0, 0, 1));
    EXPECT_EQ(scene.cameras[0].yfov, 1);
}

TEST(AnimationPointer, SplinesStayWithinWhatAFactorMayBe) {
    Accessors more;
    const auto times = more.floats("SCALAR", 2, {0, 1});
    // From 1 to 1 with steep tangents: 1 + 8 (t^3 - 2t^2 + t) exceeds 1.
    const auto spline = more.floats("SCALAR", 6, {0, 1, 8, 0, 1, 0});
    Loaded loaded = load_text(document(
        everything(more, animations(channel(0, "/materials/0/pbrMetallicRoughness/metallicFactor"),
                                    sampler(times, spline, "CUBICSPLINE")))));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    ASSERT_TRUE(pose_scene(*loaded.scene, PoseTime{{0}, 0.25}));
    EXPECT_EQ(loaded.scene->materials[0].metallic, 1);
}

TEST(AnimationPointer, HidesAndShowsNodes) {
    Accessors more;
    const auto times = more.floats("SCALAR", 3, {0, 1, 2});
    const auto shown = more.add<std::uint8_t>("SCALAR", 5121, 3, {1, 0, 7});
    const std::string visible = "/nodes/0/extensions/KHR_node_visibility/visible";
    Loaded loaded = load_text(
        document(everything(more, animations(channel(0, visible), sampler(times, shown, "STEP")))));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    Scene& scene = *loaded.scene;
    for (const auto& [seconds, expected] : {std::pair{0.5, true}, {1.5, false}, {2.5, true}}) {
        ASSERT_TRUE(pose_scene(scene, PoseTime{{0}, seconds}));
        EXPECT_EQ(visible_nodes(scene)[0], expected) << seconds;
    }
    ASSERT_TRUE(pose_scene(scene, PoseTime{{0}, 1.5}));
    ASSERT_TRUE(pose_scene(scene, std::nullopt));
    EXPECT_TRUE(visible_nodes(scene)[0]);
}

TEST(AnimationPointer, WhatCannotBeAnimatedIsLeftOut) {
    Accessors more;
    const auto times = more.floats("SCALAR", 2, {0, 1});
    const auto unit = more.floats("SCALAR", 2, {0, 1});
    for (const char* pointer :
         {"", "/", "/nodes", "/nodes/", "/nodes/0", "/nodes/0/", "/nodes/00/scale",
          "/nodes/-1/scale", "/nodes/99999999999999999999/scale", "/extras/a", "/nodes/0/name",
          "nodes/0/scale", "/extensions/KHR_lights_punctual/lights/", "/meshes/0/weights"}) {
        const Loaded loaded = load_text(
            document(everything(more, animations(channel(0, pointer), sampler(times, unit)))));
        ASSERT_TRUE(loaded.scene) << pointer << loaded.scene.error().line();
        EXPECT_EQ(loaded.warned("/animations/0/channels/0/target", "cannot be animated"), 1u)
            << pointer;
    }
}

TEST(AnimationPointer, RefusalsAndChannelsLeftOut) {
    Accessors more;
    const auto times = more.floats("SCALAR", 2, {0, 1});
    const auto unit = more.floats("SCALAR", 2, {0, 1});
    const auto bytes = more.add<std::uint8_t>("SCALAR", 5121, 2, {0, 1});
    const auto with = [&](const std::string& pointer, const std::string& s) {
        return everything(more, animations(channel(0, pointer), s));
    };
    const std::string good = sampler(times, unit);
    const std::string visible = "/nodes/0/extensions/KHR_node_visibility/visible";
    const char* output = "/animations/0/channels/0/sampler";
    expect_refused({
        {"wrong kind", with("/materials/0/emissiveFactor", good), output,
         "a type that is invalid for"},
        {"no steps", with(visible, sampler(times, bytes)), output,
         "STEP interpolation of unsigned bytes"},
        {"floats", with(visible, sampler(times, unit, "STEP")), output,
         "STEP interpolation of unsigned bytes"},
        {"no morph targets", with("/nodes/0/weights", good), "/animations/0/channels/0/target/node",
         "no mesh with morph targets"},
    });
    const std::string yfov = channel(0, "/cameras/0/perspective/yfov");
    const Loaded twice = load_text(document(everything(more, animations(yfov + "," + yfov, good))));
    ASSERT_TRUE(twice.scene) << twice.scene.error().line();
    EXPECT_EQ(twice.warned("/animations/0/channels/1/target", "the same target"), 1u);
    EXPECT_EQ(twice.scene->animations.at(0).values.size(), 1u);
    for (const char* pointer : {"/materials/1/alphaCutoff", "/materials/0/normalTexture/scale"}) {
        const Loaded loaded = load_text(document(with(pointer, good)));
        ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
        EXPECT_EQ(loaded.warned("/animations/0/channels/0/target", "is missing"), 1u);
    }
}

}  // namespace
}  // namespace hm::gltf_test
