// Light sampling alone, BSDF sampling alone and MIS of both are three estimators of the same image.
// All use independent samples and different seeds (docs/testing.md). Pixels are few and large:
// where BSDF sampling rarely hits a lamp, the distribution for few samples is too skewed for a
// t-test.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "gltf/load.h"
#include "scene/camera.h"
#include "support/pictures.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Shot;
using test::Studio;

// A floor and spheres with roughness 0.3 and above.
SceneBuilder rough_things() {
    SceneBuilder b;
    auto material = [&](vec3 color, float metallic, float roughness) {
        Material m;
        m.base_color = vec4(color, 1);
        m.metallic = metallic;
        m.roughness = roughness;
        return b.material(m);
    };
    b.place(
        b.quad(vec3(-2, -0.5f, 2), vec3(4, 0, 0), vec3(0, 0, -4), material(vec3(0.6f), 0, 0.5f)));
    const vec3 colors[] = {vec3(0.9f, 0.6f, 0.3f), vec3(0.2f, 0.5f, 0.8f), vec3(0.8f)};
    for (int i = 0; i < 3; ++i)
        b.place(b.sphere(32, material(colors[i],
                                      i == 0   ? 1.0f
                                      : i == 1 ? 0.0f
                                               : 0.5f,
                                      0.3f + 0.35f * float(i))),
                glm::scale(glm::translate(glm::mat4(1), vec3(float(i) - 1, 0, 0)), vec3(0.45f)));
    return b;
}

CameraData things_camera() {
    return camera_look_at(vec3(0, 1.2f, 4), vec3(0), vec3(0, 1, 0), 0.6f, 1);
}

EnvironmentMap uneven_sky() {
    test::Random random(17);
    std::vector<vec3> texels;
    for (int i = 0; i < 16 * 8; ++i)
        texels.push_back(i % 3 == 0 ? vec3(0) : vec3(random.unit(), random.unit(), random.unit()));
    texels[2 * 16 + 11] = vec3(40, 30, 20);
    return make_environment(test::environment_image(16, 8, texels), 20, 1);
}

void compare_strategies(Studio& studio, const CameraData& camera, Shot shot,
                        std::initializer_list<uint> strategies) {
    std::vector<std::vector<test::Picture>> pictures;
    const char* const names[] = {"MIS", "light only", "BSDF only"};
    for (uint strategy : strategies) {
        shot.strategy = strategy;
        pictures.push_back(test::replicate(studio, camera, shot, 16, 1000 * (strategy + 1)));
    }
    for (std::size_t i = 1; i < pictures.size(); ++i)
        test::expect_same_pictures(
            pictures[0], pictures[i],
            std::string(names[*strategies.begin()]) + " and " + names[*(strategies.begin() + i)]);
}

TEST(Strategies, AgreeUnderAnUnevenSky) {
    SceneBuilder b = rough_things();
    Studio studio(b.scene, uneven_sky());
    compare_strategies(studio, things_camera(),
                       {.width = 6, .height = 6, .samples = 256, .bounces = 3},
                       {kStrategyMis, kStrategyLight, kStrategyBsdf});
}

TEST(Strategies, AgreeUnderEmissiveTriangles) {
    SceneBuilder b = rough_things();
    Material m = test::emitter(vec3(6, 5, 4));
    m.emissive_texture.image = b.image(2, 2, {vec4(1), vec4(0.5f), vec4(0.2f), vec4(1)});
    m.double_sided = true;
    b.place(b.quad(vec3(-1, 1.2f, -0.5f), vec3(2, 0, 0), vec3(0, 0.5f, 1), b.material(m)));
    Studio studio(b.scene);
    compare_strategies(studio, things_camera(),
                       {.width = 6, .height = 6, .samples = 256, .bounces = 3},
                       {kStrategyMis, kStrategyLight, kStrategyBsdf});
}

TEST(Strategies, AgreeUnderAMixOfLightsWithAndWithoutCompensation) {
    SceneBuilder b = rough_things();
    Material m = test::emitter(vec3(3));
    m.alpha_mode = kAlphaBlend;
    m.base_color.w = 0.5f;
    b.place(b.quad(vec3(-1, 1.2f, -1), vec3(2, 0, 0), vec3(0, 0, 2), b.material(m)));
    Studio studio(b.scene, uneven_sky());
    for (bool compensation : {true, false}) {
        Shot shot{.width = 6, .height = 6, .samples = 128, .bounces = 0};
        shot.energy_compensation = compensation;
        compare_strategies(studio, things_camera(), shot, {kStrategyMis, kStrategyBsdf});
    }
}

std::vector<std::filesystem::path> shipped_scenes() {
    const char* root = std::getenv("HIMALAYA_SOURCE_DIR");
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(root ? root : ".") / "scenes"))
        if (entry.path().extension() == ".glb") files.push_back(entry.path());
    return files;
}

TEST(Strategies, AgreeOnTheShippedScenes) {
    const auto files = shipped_scenes();
    EXPECT_GE(files.size(), 2u);
    for (const std::filesystem::path& file : files) {
        SCOPED_TRACE(file.filename());
        Diagnostics diagnostics;
        Result<Scene> scene = load_gltf(file, diagnostics);
        ASSERT_TRUE(scene) << scene.error().line();
        const std::vector<glm::dmat4> world = world_transforms(*scene);
        Camera lens;
        glm::mat4 place(1);
        for (std::size_t i = 0; i < scene->nodes.size(); ++i)
            if (int c = scene->nodes[i].camera; c != kUnset) {
                lens = scene->cameras[std::size_t(c)];
                place = world[i];
                break;
            }
        Studio studio(std::move(*scene), make_environment(default_environment(), 0, 1),
                      {.punctual = false});
        compare_strategies(studio, camera_from_node(lens, place, 1),
                           {.width = 6, .height = 6, .samples = 128, .bounces = 4},
                           {kStrategyMis, kStrategyBsdf});
    }
}

}  // namespace
}  // namespace hm
