// AOVs against closed forms: the surface seen at a point and the components of its light are known;
// and for any scene, the light passes sum to the beauty pass.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "output/layers.h"
#include "scene/light_groups.h"
#include "support/pictures.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Shot;
using test::Studio;

constexpr float kPi = std::numbers::pi_v<float>;

std::vector<Aov> every_aov() {
    return *parse_aovs("all,variance");
}

std::vector<Aov> without_variance() {
    return *parse_aovs("all");
}

// One channel of the finished image.
std::vector<float> channel(const Film& film, std::string_view layer, std::string_view name) {
    std::vector<std::string> names(100, "name");
    const LayeredImage picture =
        film_layers(film, {film.crop.x1, film.crop.y1, true, {}, {names, names, names}, {}});
    const Layer* found = picture.find(layer);
    if (!found || !found->find(name)) {
        ADD_FAILURE() << layer << "." << name << " is not there";
        return std::vector<float>(film.sums.size());
    }
    return found->find(name)->values;
}

vec3 first_pixel(const Film& film, std::string_view layer, std::string_view channels = "RGB") {
    vec3 value;
    for (std::size_t c = 0; c < 3; ++c)
        value[c] = channel(film, layer, channels.substr(c, 1))[0];
    return value;
}

void expect_near(vec3 a, vec3 b, float tolerance) {
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(a[c], b[c], tolerance * std::max(1.0f, std::abs(b[c]))) << c;
}

// A room with every kind of surface and light: lamp, point light, unlit board, metal, plastic,
// alpha-blended glass, and an open side that lets in the sky.
SceneBuilder crowded_room() {
    SceneBuilder b;
    Material metal;
    metal.name = "metal";
    metal.base_color = vec4(0.9f, 0.6f, 0.3f, 1);
    metal.roughness = 0.3f;
    Material plastic;
    plastic.name = "plastic";
    plastic.base_color = vec4(0.2f, 0.5f, 0.8f, 1);
    plastic.metallic = 0.2f;
    plastic.roughness = 0.4f;
    Material veil = test::lambertian(vec3(0.3f, 0.8f, 0.3f));
    veil.alpha_mode = kAlphaBlend;
    veil.base_color.w = 0.5f;
    Material board = test::lambertian(vec3(0.9f, 0.2f, 0.5f));
    board.unlit = true;
    board.name = "board";
    Material lamp = test::emitter(vec3(8, 6, 4));
    lamp.name = "lamp";
    const int wall = b.material(test::lambertian(vec3(0.7f)));
    b.place(b.quad(vec3(-1, -1, -1), vec3(0, 0, 2), vec3(2, 0, 0), wall));
    b.place(b.quad(vec3(-1, -1, -1), vec3(2, 0, 0), vec3(0, 2, 0), wall));
    b.place(
        b.quad(vec3(-0.4f, 0.98f, -0.4f), vec3(0.8f, 0, 0), vec3(0, 0, 0.8f), b.material(lamp)));
    b.place(b.quad(vec3(0.4f, 0.1f, 0), vec3(0.4f, 0, 0), vec3(0, 0.4f, 0), b.material(board)));
    const auto ball = [&](const Material& m, vec3 at) {
        b.place(b.sphere(24, b.material(m)),
                glm::scale(glm::translate(glm::mat4(1), at), vec3(0.35f)));
    };
    ball(metal, vec3(0.5f, -0.6f, 0));
    ball(plastic, vec3(-0.3f, -0.6f, 0.1f));
    ball(veil, vec3(-0.1f, 0, 0.3f));
    Light bulb;
    bulb.name = "bulb";
    bulb.intensity = 0.6f;
    b.light(bulb, glm::translate(glm::mat4(1), vec3(0.7f, 0.5f, 0.7f)));
    return b;
}

CameraData room_camera() {
    CameraData c = test::flat_camera(vec3(0), vec3(0.1f, 0.1f, 1), 0.8f);
    c.kind = kCameraPerspective;
    c.origin = vec3(0.1f, 0.1f, 2);
    return c;
}

constexpr const char* kPasses[] = {"emission", "diffuse_direct", "specular_direct",
                                   "diffuse_indirect", "specular_indirect"};

// All are sums of the same non-negative contributions. Each addition rounds by half an ulp, so n
// samples with at most 2 * bounces + 1 contributions in 6 parts are within
// n * (2 * bounces + 7) units of 2^-24.
void expect_parts_sum_up(const Film& film, const Shot& shot) {
    const float units = float(shot.samples) * float(2 * (shot.bounces ? shot.bounces : 40) + 7);
    for (const char* name : {"R", "G", "B"}) {
        const std::vector<float> beauty = channel(film, "", name);
        std::vector<float> passes(beauty.size()), groups(beauty.size());
        for (const char* pass : kPasses) {
            const std::vector<float> values = channel(film, pass, name);
            for (std::size_t i = 0; i < values.size(); ++i)
                passes[i] += values[i];
        }
        for (const std::string& group : film.selection.light_groups) {
            const std::vector<float> values = channel(film, "light_group_" + group, name);
            for (std::size_t i = 0; i < values.size(); ++i)
                groups[i] += values[i];
        }
        for (std::size_t i = 0; i < beauty.size(); ++i) {
            const float tolerance = 0x1p-24f * units * beauty[i];
            ASSERT_NEAR(passes[i], beauty[i], tolerance) << "pixel " << i << " of " << name;
            ASSERT_NEAR(groups[i], beauty[i], tolerance) << "pixel " << i << " of " << name;
        }
    }
}

TEST(Aovs, PartsOfTheLightSumToTheBeauty) {
    Studio studio(crowded_room().scene, test::constant_environment(vec3(0.3f, 0.4f, 0.6f)));
    Shot shot{.width = 24, .height = 16, .samples = 32, .bounces = 5};
    for (const uint background : {kBackgroundEnvironment, kBackgroundTransparent})
        for (const float clamp : {0.0f, 0.5f})
            for (const uint strategy : {kStrategyMis, kStrategyBsdf})
                for (const uint bounces : {0u, 1u, 5u}) {
                    shot.background = background;
                    shot.clamp = clamp;
                    shot.strategy = strategy;
                    shot.bounces = bounces;
                    const Film film = studio.render_film(room_camera(), shot, every_aov());
                    ASSERT_EQ(film.selection.light_groups.size(), 4u);
                    expect_parts_sum_up(film, shot);
                }
}

TEST(Aovs, AskingForThemChangesNoBitOfTheBeauty) {
    Studio studio(crowded_room().scene, test::constant_environment(vec3(0.3f, 0.4f, 0.6f)));
    for (const uint sampler : {kSamplerIndependent, kSamplerSobolBlueNoise, kSamplerSobolOwen}) {
        const Shot shot{.width = 24, .height = 16, .samples = 8, .bounces = 4, .sampler = sampler};
        const std::vector<PixelSum> plain = studio.render_sums(room_camera(), shot, {0, 0, 24, 16});
        const Film film = studio.render_film(room_camera(), shot, without_variance());
        EXPECT_EQ(std::memcmp(plain.data(), film.sums.data(), plain.size() * sizeof(PixelSum)), 0);
    }
}

TEST(Aovs, RangesOfSamplesJoinToTheSameFilm) {
    Studio studio(crowded_room().scene, test::constant_environment(vec3(0.3f)));
    Shot shot{.width = 12, .height = 8, .samples = 24, .bounces = 3, .sampler = kSamplerSobolOwen};
    const Film whole = studio.render_film(room_camera(), shot, every_aov());
    Film joined({0, 0, 12, 8}, whole.selection);
    for (const auto& [begin, end] : {std::pair{17u, 24u}, {0u, 5u}, {5u, 17u}}) {
        Shot part = shot;
        part.first_sample = begin;
        part.samples = end - begin;
        merge_film(joined, studio.render_film(room_camera(), part, every_aov()));
    }
    for (std::size_t p = 0; p < whole.planes.size(); ++p)
        for (std::size_t i = 0; i < whole.planes[p].values.size(); ++i) {
            const float expected = whole.planes[p].values[i];
            ASSERT_NEAR(joined.planes[p].values[i], expected, 1e-5f * std::abs(expected) + 1e-6f)
                << whole.planes[p].name << " " << i;
        }
    for (std::size_t i = 0; i < whole.ids.size(); ++i) {
        ASSERT_EQ(joined.ids[i].size(), whole.ids[i].size());
        for (std::size_t k = 0; k < whole.ids[i].size(); ++k)
            EXPECT_EQ(joined.ids[i][k].count, whole.ids[i][k].count);
    }
}

// A tilted board, seen at a single point, under one directional light.
struct Board {
    SceneBuilder b;
    vec3 normal = normalize(vec3(0.3f, 0.2f, 1));
    vec3 point{0.1f, -0.2f, 0.3f};
    vec3 light_color{3, 2, 1};

    explicit Board(const Material& material) {
        b.material(test::lambertian(vec3(0.5f)));  // so that the board's index is not 0
        const vec3 u = normalize(cross(vec3(0, 1, 0), normal)), v = cross(normal, u);
        // The point has the texture coordinates (0.25, 0.75).
        b.place(b.quad(point - u * 1.0f - v * 3.0f, u * 4.0f, v * 4.0f, b.material(material)));
        Light sun;
        sun.kind = kLightDirectional;
        sun.color = light_color;
        b.light(sun);  // along -z
    }
    // Looking along -z from 2 m above the point.
    CameraData camera() const {
        CameraData c = test::point_camera(point, vec3(0, 0, 1));
        c.origin = point + vec3(0, 0, 2);
        return c;
    }
};

TEST(Aovs, SurfacesAreWhatTheyAre) {
    Material m;
    m.base_color = vec4(0.8f, 0.4f, 0.2f, 1);
    m.metallic = 0.25f;
    m.roughness = 0.6f;
    const Board board(m);
    Studio studio(board.b.scene);
    const Shot shot{.width = 1, .height = 1, .samples = 5, .bounces = 2};
    const Film film = studio.render_film(board.camera(), shot, every_aov());
    const vec3 base(0.8f, 0.4f, 0.2f);
    const vec3 f0 = vec3(0.04f * 0.75f) + base * 0.25f;
    expect_near(first_pixel(film, "albedo"), base * 0.75f + f0, 1e-5f);
    EXPECT_NEAR(channel(film, "metallic", "Y")[0], 0.25f, 1e-6f);
    EXPECT_NEAR(channel(film, "roughness", "Y")[0], 0.6f, 1e-6f);
    expect_near(first_pixel(film, "normal", "XYZ"), board.normal, 1e-5f);
    expect_near(first_pixel(film, "geometric_normal", "XYZ"), board.normal, 1e-5f);
    EXPECT_NEAR(channel(film, "depth", "Z")[0], 2.0f, 1e-5f);
    expect_near(first_pixel(film, "position", "XYZ"), board.point, 1e-5f);
    EXPECT_NEAR(channel(film, "uv", "U")[0], 0.25f, 1e-5f);
    EXPECT_NEAR(channel(film, "uv", "V")[0], 0.75f, 1e-5f);
    EXPECT_EQ(channel(film, "material_id", "Y")[0], 2.0f);
    EXPECT_EQ(channel(film, "instance_id", "Y")[0], 1.0f);
    EXPECT_EQ(channel(film, "samples", "Y")[0], 5.0f);
    expect_near(first_pixel(film, "emission"), vec3(0), 0);
    EXPECT_EQ(channel(film, "forward", "u")[0], 0.0f);
}

// Looking straight down at a board, lit at normal incidence by a light behind the camera, all
// vectors coincide: the lobes of Appendix B are base (1 - F0) (1 - metallic) / pi and
// F0 / (4 pi alpha^2).
TEST(Aovs, DirectLightIsSplitByTheLobes) {
    for (const float metallic : {0.0f, 0.5f, 1.0f}) {
        SCOPED_TRACE(metallic);
        Material m;
        m.base_color = vec4(0.8f, 0.4f, 0.2f, 1);
        m.metallic = metallic;
        m.roughness = 0.5f;
        SceneBuilder b;
        b.place(b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), b.material(m)));
        Light sun;
        sun.kind = kLightDirectional;
        sun.color = vec3(3, 2, 1);
        b.light(sun);
        Studio studio(b.scene);
        const Shot shot{
            .width = 1, .height = 1, .samples = 4, .bounces = 3, .energy_compensation = false};
        const CameraData camera = test::point_camera(vec3(0.1f, 0.2f, 0), vec3(0, 0, 1));
        const Film film = studio.render_film(camera, shot, every_aov());
        const vec3 base(0.8f, 0.4f, 0.2f), light(3, 2, 1);
        const vec3 f0 = vec3(0.04f * (1 - metallic)) + base * metallic;
        const float alpha = 0.25f;
        expect_near(first_pixel(film, "diffuse_direct"),
                    light * base * ((1 - metallic) * 0.96f / kPi), 1e-4f);
        expect_near(first_pixel(film, "specular_direct"), light * f0 / (4 * kPi * alpha * alpha),
                    1e-4f);
        expect_near(first_pixel(film, "diffuse_indirect"), vec3(0), 0);
        expect_near(first_pixel(film, "specular_indirect"), vec3(0), 0);
        expect_near(first_pixel(film, "light_group_light_0"), first_pixel(film, ""), 1e-6f);
        expect_near(first_pixel(film, "light_group_environment"), vec3(0), 0);
    }
}

// Inside a closed box of albedo a and emission E, the k-th bounce of a path adds E a^k.
TEST(Aovs, BouncesFallIntoTheirPasses) {
    const float albedo = 0.5f;
    const vec3 emission(1, 0.5f, 0.25f);
    SceneBuilder b;
    Material m = test::lambertian(vec3(albedo));
    m.emissive_factor = emission;
    b.place(test::add_cube(b, true, b.material(m)));
    Studio studio(b.scene);
    CameraData camera = test::flat_camera(vec3(0.2f, -0.1f, 0.3f), vec3(1, 2, 3), 0.3f);
    camera.origin = vec3(0.2f, -0.1f, 0.3f);
    // Every BSDF sample hits the same emission, and Russian roulette starts only after two bounces.
    const Shot shot{.samples = 4, .bounces = 2, .strategy = kStrategyBsdf};
    const Film film = studio.render_film(camera, shot, every_aov());
    expect_near(first_pixel(film, "emission"), emission, 1e-5f);
    expect_near(first_pixel(film, "diffuse_direct"), emission * albedo, 1e-4f);
    expect_near(first_pixel(film, "diffuse_indirect"), emission * albedo * albedo, 1e-4f);
    expect_near(first_pixel(film, "specular_direct"), vec3(0), 0);
    expect_near(first_pixel(film, "specular_indirect"), vec3(0), 0);
    expect_near(first_pixel(film, "light_group_material_0"), first_pixel(film, ""), 1e-5f);
}

TEST(Aovs, LightsAddUpByTheirGroups) {
    SceneBuilder b;
    b.place(b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0),
                   b.material(test::lambertian(vec3(0.5f)))));
    Light sun;
    sun.kind = kLightDirectional;
    sun.name = "sun.key";
    sun.color = vec3(2, 0, 0);
    b.light(sun);
    sun.color = vec3(0, 3, 0);  // another one with the same name
    b.light(sun);
    Studio studio(b.scene, test::constant_environment(vec3(0, 0, 4)));
    // Light sampling picks one light per sample at random, so many samples are needed.
    const Shot shot{.width = 4, .height = 4, .samples = 20000, .bounces = 1};
    const CameraData camera = test::point_camera(vec3(0), vec3(0, 0, 1));
    const Film film = studio.render_film(camera, shot, {Aov::light_groups});
    ASSERT_EQ(film.selection.light_groups,
              (std::vector<std::string>{"environment", "sun_key", "sun_key_2"}));
    expect_near(first_pixel(film, "light_group_sun_key"), vec3(2 * 0.5f / kPi, 0, 0), 0.03f);
    expect_near(first_pixel(film, "light_group_sun_key_2"), vec3(0, 3 * 0.5f / kPi, 0), 0.03f);
    expect_near(first_pixel(film, "light_group_environment"), vec3(0, 0, 2), 0.03f);
}

// A board covers part of the image: depth and position average over hits only, normals are
// premultiplied by alpha, and the coverage of mattes equals alpha.
TEST(Aovs, EdgesAndBackground) {
    SceneBuilder b;
    b.place(b.quad(vec3(-1, -1, 0), vec3(1.3f, 0, 0), vec3(0, 2, 0),
                   b.material(test::lambertian(vec3(0.6f, 0.5f, 0.4f)))));
    Studio studio(b.scene, test::constant_environment(vec3(1)));
    const Shot shot{.samples = 64, .bounces = 1, .background = kBackgroundTransparent};
    CameraData camera = test::flat_camera(vec3(0), vec3(0, 0, 1), 0.8f);
    camera.origin = vec3(0, 0, 3);
    const Film film = studio.render_film(camera, shot, every_aov());
    const auto alpha = channel(film, "", "A"), depth = channel(film, "depth", "Z"),
               normal = channel(film, "normal", "Z"), red = channel(film, "albedo", "R"),
               id = channel(film, "instance_id", "Y"), matte = channel(film, "CryptoObject00", "G"),
               z = channel(film, "position", "Z");
    int edges = 0;
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        edges += alpha[i] > 0 && alpha[i] < 1 ? 1 : 0;
        EXPECT_EQ(depth[i], alpha[i] > 0 ? 3.0f : kDepthOfNothing);
        EXPECT_EQ(z[i], 0.0f);
        EXPECT_NEAR(normal[i], alpha[i], 1e-6f);
        EXPECT_NEAR(red[i], 0.6f * alpha[i], 1e-5f);
        EXPECT_EQ(id[i], alpha[i] > 0 ? 1.0f : 0.0f);
        EXPECT_EQ(matte[i], alpha[i]);
    }
    EXPECT_EQ(edges, 8);  // the board's right side, at 0.3, crosses a column of pixels
}

TEST(Aovs, UnlitSurfacesEmitTheirColour) {
    SceneBuilder b;
    Material m = test::lambertian(vec3(0.6f, 0.5f, 0.4f));
    m.unlit = true;
    m.name = "sign";
    b.place(b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), b.material(m)));
    Studio studio(b.scene);
    const Film film = studio.render_film(test::point_camera(vec3(0), vec3(0, 0, 1)),
                                         {.width = 1, .height = 1, .samples = 2}, every_aov());
    expect_near(first_pixel(film, "emission"), vec3(0.6f, 0.5f, 0.4f), 1e-6f);
    expect_near(first_pixel(film, "albedo"), vec3(0.6f, 0.5f, 0.4f), 1e-6f);
    expect_near(first_pixel(film, "light_group_sign"), vec3(0.6f, 0.5f, 0.4f), 1e-6f);
}

SceneBuilder moving_board(vec3 offset, bool deformed) {
    SceneBuilder b;
    const int mesh = b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0),
                            b.material(test::lambertian(vec3(0.5f))));
    if (!deformed) {
        b.place(mesh, glm::translate(glm::mat4(1), offset));
        return b;
    }
    // As after posing: the vertices are moved.
    Primitive& primitive = b.scene.meshes[0].primitives[0];
    Deformation deformation;
    deformation.rest = primitive.vertices;
    primitive.deformation = std::make_shared<const Deformation>(deformation);
    for (Vertex& vertex : primitive.vertices)
        vertex.position += offset;
    b.place(mesh);
    return b;
}

// 16 pixels cover 1.6 m: ten pixels per metre. Upward in the image is positive `v`.
TEST(Aovs, MotionIsInPixelsToTheNextFrame) {
    CameraData camera = test::flat_camera(vec3(0), vec3(0, 0, 1), 0.8f);
    camera.origin = vec3(0, 0, 3);
    const Shot shot{.width = 16, .height = 16, .samples = 2, .bounces = 1};
    const auto expect_motion = [&](Studio& studio, const CameraData& next, float u, float v) {
        const Film film = studio.render_film(camera, shot, {Aov::motion}, next);
        for (std::size_t i = 0; i < film.sums.size(); ++i) {
            EXPECT_NEAR(channel(film, "forward", "u")[i], u, 1e-4f);
            EXPECT_NEAR(channel(film, "forward", "v")[i], v, 1e-4f);
        }
    };
    for (const bool deformed : {false, true}) {
        SCOPED_TRACE(deformed);
        Studio studio(moving_board(vec3(0), deformed).scene);
        expect_motion(studio, camera, 0, 0);
        studio.set_next(moving_board(vec3(0.2f, 0.1f, 0), deformed).scene);
        expect_motion(studio, camera, 2, 1);
        CameraData panned = camera;  // panning right moves everything to the left
        panned.origin.x += 0.5f;
        expect_motion(studio, panned, -3, 1);
    }
    // In perspective, approaching points move away from the centre: from depth 3 to 1.5.
    camera.kind = kCameraPerspective;
    Studio studio(moving_board(vec3(0), false).scene);
    studio.set_next(moving_board(vec3(0, 0, 1.5f), false).scene);
    const Film film = studio.render_film(camera, shot, {Aov::motion, Aov::position}, camera);
    const auto u = channel(film, "forward", "u"), v = channel(film, "forward", "v");
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        if (film.find_plane(kPlaneMotion)->values[3 * i + 2] == 0) continue;
        // First the point is at the pixel, to within half a pixel; then twice as far out.
        EXPECT_NEAR(u[i], float(i % 16) - 7.5f, 0.51f);
        EXPECT_NEAR(v[i], 7.5f - float(i / 16), 0.51f);
    }
}

}  // namespace
}  // namespace hm
