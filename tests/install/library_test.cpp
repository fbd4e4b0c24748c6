// The public library: errors, cancelling, layers and exceptions of callbacks.
#include <gtest/gtest.h>
#include <himalaya/himalaya.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace {

using namespace himalaya;

std::string source_file(const std::string& name) {
    const char* source = std::getenv("HIMALAYA_SOURCE_DIR");
    return std::string(source != nullptr ? source : ".") + "/" + name;
}

RenderSettings small_settings() {
    RenderSettings settings;
    settings.frame.width = 24;
    settings.frame.height = 16;
    settings.sampling.samples = 2;
    return settings;
}

Renderer cpu() {
    return Renderer({.kind = DeviceSettings::Kind::cpu, .threads = 2});
}

template <class Call>
ErrorKind kind_of(Call call) {
    try {
        call();
    } catch (const Error& error) {
        EXPECT_FALSE(std::string(error.what()).empty());
        return error.kind();
    }
    ADD_FAILURE() << "no error";
    return ErrorKind::internal;
}

TEST(Library, RendersAFileWithLayers) {
    Scene scene = Scene::load(source_file("scenes/cornell.glb"));
    RenderSettings settings = small_settings();
    settings.aovs = {"albedo", "depth"};
    settings.frame.crop = Crop{4, 2, 14, 10};
    const Picture picture = cpu().render(scene, settings);
    EXPECT_EQ(picture.width(), 10u);
    EXPECT_EQ(picture.height(), 8u);
    EXPECT_EQ(picture.pixels().size(), 4u * 10 * 8);
    EXPECT_TRUE(picture.complete());
    EXPECT_EQ(picture.samples_per_pixel(), 2);
    EXPECT_EQ(picture.device(), "CPU");
    EXPECT_EQ(picture.layer("albedo").channels.size(), 3u);
    EXPECT_EQ(picture.layer("depth").values.size(), 80u);
    double sum = 0;
    for (const float value : picture.pixels())
        sum += double(value);
    EXPECT_TRUE(std::isfinite(sum) && sum > 80) << sum;  // alpha alone is 80
}

TEST(Library, ErrorsHaveAKind) {
    EXPECT_EQ(kind_of([] { Scene::load("/nowhere.glb"); }), ErrorKind::unreadable);
    Scene scene = Scene::load(source_file("scenes/cornell.glb"));
    RenderSettings settings = small_settings();
    settings.view.camera = "no such camera";
    EXPECT_EQ(kind_of([&] { cpu().render(scene, settings); }), ErrorKind::invalid_argument);
    settings = small_settings();
    settings.aovs = {"no such layer"};
    EXPECT_EQ(kind_of([&] { cpu().render(scene, settings); }), ErrorKind::invalid_argument);
    settings = small_settings();
    settings.frame.width = 0;
    EXPECT_EQ(kind_of([&] { cpu().render(scene, settings); }), ErrorKind::invalid_argument);
    const Picture picture = cpu().render(scene, small_settings());
    EXPECT_EQ(kind_of([&] { picture.layer("depth"); }), ErrorKind::invalid_argument);
    EXPECT_EQ(kind_of([&] { picture.write("/tmp/picture.xyz"); }), ErrorKind::invalid_argument);
    EXPECT_EQ(kind_of([&] { picture.write("/nowhere/a.exr"); }), ErrorKind::unwritable);
}

TEST(Library, ArraysAreChecked) {
    const std::array<Vec3, 3> positions = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
    const std::array<Triangle, 1> outside = {Triangle{0, 1, 3}};
    Scene scene;
    Mesh mesh;
    mesh.positions = positions;
    mesh.triangles = outside;
    EXPECT_EQ(kind_of([&] { scene.add_mesh(mesh); }), ErrorKind::invalid_argument);
    EXPECT_EQ(kind_of([&] { scene.add_instance(0); }), ErrorKind::invalid_argument);
    const std::array<std::uint8_t, 3> bytes = {};
    EXPECT_EQ(kind_of([&] { scene.add_texture({1, 1, bytes}); }), ErrorKind::invalid_argument);
    Material material;
    material.base_color_texture = TextureSlot{};
    EXPECT_EQ(kind_of([&] { scene.add_material(material); }), ErrorKind::invalid_argument);
}

TEST(Library, ATextureAndANormalMapAreRead) {
    const std::array<Vec3, 3> positions = {Vec3{-9, -9, 0}, Vec3{9, -9, 0}, Vec3{0, 9, 0}};
    const std::array<Vec2, 3> uvs = {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}};
    const std::array<Triangle, 1> triangles = {Triangle{0, 1, 2}};
    const std::array<std::uint8_t, 4> red = {255, 0, 0, 255}, flat = {128, 128, 255, 255};
    Scene scene;
    Material material;
    material.specular = 0;
    material.base_color_texture = TextureSlot{scene.add_texture({1, 1, red})};
    material.normal_texture = TextureSlot{scene.add_texture({1, 1, flat})};
    Mesh mesh;
    mesh.positions = positions;
    mesh.triangles = triangles;
    mesh.uvs = uvs;
    mesh.material = scene.add_material(material);
    scene.add_instance(scene.add_mesh(mesh));
    Light sun;
    sun.kind = Light::Kind::directional;
    scene.add_light(sun);
    scene.add_camera({}, translation({0, 0, 2}));
    const Picture picture = cpu().render(scene, small_settings());
    const std::span<const float> middle = picture.pixels().subspan(4 * (8 * 24 + 12), 4);
    EXPECT_NEAR(middle[0], 1 / 3.14159265f, 2e-3f);  // 8 bits hold no exact (0, 0, 1)
    EXPECT_EQ(middle[1], 0);
}

// A floor under a lamp, seen by a camera, all moved by `offset`.
Scene lit_floor(Vec3d offset) {
    const std::array<Vec3, 4> corners = {Vec3{-2, 0, 2}, Vec3{2, 0, 2}, Vec3{2, 0, -2},
                                         Vec3{-2, 0, -2}};
    const std::array<Triangle, 2> triangles = {Triangle{0, 1, 2}, Triangle{0, 2, 3}};
    const auto at = [&](double x, double y, double z) {
        return translation({offset.x + x, offset.y + y, offset.z + z});
    };
    Scene scene;
    Mesh mesh;
    mesh.positions = corners;
    mesh.triangles = triangles;
    scene.add_instance(scene.add_mesh(mesh), at(0.013, -0.5, -6.1));
    Light lamp;
    lamp.intensity = 10;
    scene.add_light(lamp, at(0.7, 1.3, -5.2));
    scene.add_camera({}, at(0.1, 0.2, 0));
    return scene;
}

// The transforms' doubles resolve 1e-10 m at this distance, floats 0.06 m.
TEST(Library, AFarSceneIsRenderedLikeANearOne) {
    const Vec3d far{1e6 + 0.37, -2e6 - 0.11, 3e6 + 0.53};
    Scene near_scene = lit_floor({}), far_scene = lit_floor(far);
    RenderSettings settings = small_settings();
    settings.aovs = {"depth"};
    for (const bool from_eye : {false, true}) {
        SCOPED_TRACE(from_eye);
        if (from_eye) {
            settings.view.eye = Vec3d{0.1, 0.2, 0};
            settings.view.target = Vec3d{0, -0.5, -6};
        }
        const Picture near_picture = cpu().render(near_scene, settings);
        if (from_eye) {
            settings.view.eye = Vec3d{far.x + 0.1, far.y + 0.2, far.z};
            settings.view.target = Vec3d{far.x, far.y - 0.5, far.z - 6};
        }
        const Picture far_picture = cpu().render(far_scene, settings);
        float brightest = 0;
        for (std::size_t i = 0; i < near_picture.pixels().size(); ++i) {
            const float expected = near_picture.pixels()[i];
            EXPECT_NEAR(far_picture.pixels()[i], expected, 1e-4f * expected + 1e-6f) << i;
            brightest = std::max(brightest, i % 4 == 3 ? 0 : expected);
        }
        EXPECT_GT(brightest, 0.1f);
        const Layer depth = near_picture.layer("depth"), far_depth = far_picture.layer("depth");
        for (std::size_t i = 0; i < depth.values.size(); ++i)
            EXPECT_NEAR(far_depth.values[i], depth.values[i], 1e-4f) << i;
    }
}

// The sum of relative squared errors: the edges of the lamp would dominate absolute ones.
double error_of(const Picture& picture, const Picture& reference) {
    double sum = 0;
    for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
        const double expected = double(reference.pixels()[i]);
        const double difference = double(picture.pixels()[i]) - expected;
        sum += difference * difference / (expected * expected + 0.01);
    }
    return sum;
}

// Open Image Denoise is optional: without it the picture is refused, not rendered noisy.
TEST(Library, Denoises) {
    Scene scene = Scene::load(source_file("scenes/cornell.glb"));
    RenderSettings settings;
    settings.frame.width = settings.frame.height = 64;
    settings.light.environment = Environment::none;
    settings.sampling.samples = 4;
    const Picture noisy = cpu().render(scene, settings);
    settings.denoise = true;
    if (!std::filesystem::exists(source_file("build/oidn/version"))) {
        try {
            cpu().render(scene, settings);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::no_device);
            GTEST_SKIP() << error.what();
        }
    }
    const Picture denoised = cpu().render(scene, settings);
    settings.denoise = false;
    settings.sampling.samples = 256;
    const Picture reference = cpu().render(scene, settings);
    EXPECT_LT(error_of(denoised, reference), 0.5 * error_of(noisy, reference));

    // The samples are the same, and what was denoised is a layer beside them.
    const std::vector<std::string> names = denoised.layer_names();
    EXPECT_EQ(std::count(names.begin(), names.end(), "denoised"), 1);
    const Layer layer = denoised.layer("denoised");
    const std::size_t channels = layer.channels.size();
    ASSERT_EQ(layer.values.size(), channels * 64 * 64);
    for (std::size_t i = 0; i < 64 * 64; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto at =
                std::find(layer.channels.begin(), layer.channels.end(), std::string(1, "RGB"[c])) -
                layer.channels.begin();
            ASSERT_EQ(layer.values[i * channels + std::size_t(at)], denoised.pixels()[4 * i + c]);
        }
}

TEST(Library, CancelledPicturesKeepWhatWasDrawn) {
    Scene scene = Scene::load(source_file("scenes/cornell.glb"));
    RenderSettings settings = small_settings();
    settings.sampling.samples = 1u << 24;
    Renderer renderer = cpu();
    const Picture picture =
        renderer.render(scene, settings, {.progress = [](const Progress&) { return false; }});
    EXPECT_FALSE(picture.complete());
    EXPECT_GT(picture.samples_per_pixel(), 0);
    std::stop_source stop;
    stop.request_stop();
    const Picture none =
        renderer.render(scene, settings, {.progress = {}, .stop = stop.get_token()});
    EXPECT_EQ(none.samples_per_pixel(), 0);
}

TEST(Library, ExceptionsOfACallbackArePassedOn) {
    Scene scene = Scene::load(source_file("scenes/cornell.glb"));
    RenderSettings settings = small_settings();
    settings.sampling.samples = 1u << 24;
    const auto throwing = [](const Progress&) -> bool { throw std::domain_error("mine"); };
    EXPECT_THROW(cpu().render(scene, settings, {.progress = throwing}), std::domain_error);
}

}  // namespace
