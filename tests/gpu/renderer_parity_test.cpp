// The same scene, samples and seed on the CPU and as a Vulkan ray-tracing pipeline: the same
// picture. docs/testing.md says which scenes, and how to try many more.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/cli/setup.h"
#include "gltf/load.h"
#include "gpu/odd_scene.h"
#include "gpu/path_tracer.h"
#include "gpu/renderers.h"
#include "image/read.h"

namespace hm::test {

namespace {

namespace fs = std::filesystem;

fs::path source_dir() {
    const char* dir = std::getenv("HIMALAYA_SOURCE_DIR");
    return dir != nullptr ? dir : ".";
}

// A file as `himalaya render` draws it without flags beside --env.
void expect_file_parity(const fs::path& file, const std::string& env) {
    Diagnostics diagnostics;
    const Result<Scene> scene = load_gltf(file, diagnostics);
    if (!scene) return;  // broken, or asks for what we do not have
    cli::RenderOptions options;
    options.width = options.height = kPictureSize;
    options.env = env;
    auto environment = cli::choose_environment(options, *scene);
    ASSERT_TRUE(environment) << environment.error().line();
    const FlatScene flat = flatten(*scene, std::move(environment->map), {}, diagnostics);
    const auto camera = cli::choose_camera({}, *scene, flat.bounds, 1);
    ASSERT_TRUE(camera) << camera.error().line();
    Duel(flat).expect_parity(make_job(flat, camera->data), file.filename().string());
}

TEST(RendererParity, EveryFeatureAndEverySetting) {
    const TestScene scene;
    Duel duel(scene.flat);
    RenderJob job = make_job(scene.flat, scene.camera);
    duel.expect_parity(job, "features");

    RenderJob other = job;
    other.params.sampler_kind = kSamplerSobolBlueNoise;
    other.params.strategy = kStrategyBsdf;
    other.params.background = kBackgroundTransparent;
    other.params.energy_compensation = 0;
    other.camera.lens_radius = 0.1f;
    other.camera.focus_distance = 5;
    set_light_ranges(scene.flat, other.params);
    duel.expect_parity(other, "blue noise, BSDF sampling, transparent, lens");

    other = job;
    other.params.sampler_kind = kSamplerIndependent;
    other.params.strategy = kStrategyLight;
    other.params.max_bounces = 0;
    other.params.max_radiance = 2;
    other.params.diffuse_kind = kDiffuseBurley;
    other.params.background = kBackgroundColor;
    other.params.background_color = {0.1f, 0.2f, 0.3f};
    other.camera.kind = kCameraOrthographic;
    other.camera.half_width = other.camera.half_height = 2.2f;
    set_light_ranges(scene.flat, other.params);
    duel.expect_parity(other, "independent, light sampling, clamp, orthographic");
}

TEST(RendererParity, OddShapesAndPlacements) {
    const OddScene scene;
    Duel duel(scene.flat);
    EXPECT_EQ(duel.gpu().scene_report().duplicate_instances, 1u);
    EXPECT_EQ(duel.gpu().scene_report().degenerate_triangles, 3u);
    duel.expect_parity(make_job(scene.flat, scene.camera), "odd shapes and placements");
}

TEST(RendererParity, ShippedScenes) {
    const fs::path scenes = source_dir() / "scenes";
    expect_file_parity(scenes / "cornell.glb", "none");
    expect_file_parity(scenes / "spheres.glb", "");
    expect_file_parity(scenes / "hero.glb", (scenes / "hero_sky.hdr").string());
}

}  // namespace

}  // namespace hm::test
