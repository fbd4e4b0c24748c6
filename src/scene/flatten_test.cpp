// Tables made from a scene: instances, emitter indices, lights and their sample shares.
#include "scene/flatten.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/camera.h"
#include "support/light_host.h"
#include "support/scenes.h"

namespace hm {
namespace {

using test::LightHost;
using test::SceneBuilder;

const glm::mat4 kOne(1);

TEST(Flatten, MirroringTransformsFlip) {
    SceneBuilder b;
    int quad = b.quad(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), b.material(Material{}));
    b.place(quad);
    b.place(quad, glm::scale(kOne, vec3(-1, 1, 1)));
    b.place(quad, glm::scale(kOne, vec3(-2, -1, 1)));
    b.place(quad, glm::scale(kOne, vec3(-1, -1, -3)));
    FlatScene flat = test::flatten_quietly(b.scene);
    ASSERT_EQ(flat.instances.size(), 4u);
    const uint flipped[] = {0, kInstanceFlipped, 0, kInstanceFlipped};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(flat.instances[i].flags, flipped[i]) << i;
        vec3 p(0.3f, 0.7f, -2);
        vec3 world = flat.instances[i].object_to_world * vec4(p, 1);
        vec3 back = flat.instances[i].world_to_object * vec4(world, 1);
        EXPECT_LT(length(back - p), 1e-6f);
    }
}

TEST(Flatten, NodesScaledToNothingAreLeftOutWithAWarning) {
    SceneBuilder b;
    int quad = b.quad(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), kUnset);
    b.place(quad, glm::scale(kOne, vec3(1, 0, 1)));
    b.place(quad);
    b.place(quad, glm::scale(kOne, vec3(0)));
    b.place(quad);
    b.scene.nodes[0].index = 7;
    b.scene.nodes[3].index = 5;
    b.scene.nodes[3].instances = {kOne, glm::scale(kOne, vec3(0, 1, 1))};
    Diagnostics diagnostics;
    FlatScene flat = flatten(b.scene, {}, {}, diagnostics);
    EXPECT_EQ(flat.instances.size(), 2u);
    ASSERT_EQ(diagnostics.warnings().size(), 2u);
    EXPECT_EQ(diagnostics.warnings()[0].location, "/nodes/7");
    EXPECT_EQ(diagnostics.warnings()[0].count, 2u);
    EXPECT_EQ(diagnostics.warnings()[1].location, "/nodes/5");
}

TEST(Flatten, LampsAndCamerasWithoutDirectionAreWarnedOf) {
    SceneBuilder b;
    const glm::mat4 nothing = glm::scale(kOne, vec3(0));
    Light lamp;
    b.light(lamp, nothing);  // omnidirectional
    lamp.kind = kLightSpot;
    b.light(lamp, nothing);
    b.light(lamp);
    Node eye;
    eye.camera = 0;
    eye.local = nothing;
    b.scene.nodes.push_back(eye);
    b.scene.nodes[1].index = 4;
    Diagnostics diagnostics;
    const FlatScene flat = flatten(b.scene, {}, {}, diagnostics);
    EXPECT_EQ(flat.lights.at(1).direction, vec3(0, 0, -1));
    ASSERT_EQ(diagnostics.warnings().size(), 1u);
    EXPECT_EQ(diagnostics.warnings()[0].location, "/nodes/4");
    EXPECT_EQ(diagnostics.warnings()[0].count, 2u);
}

TEST(Flatten, UnsetTexturesAndMaterialsHaveDefaults) {
    SceneBuilder b;
    Material m;
    m.base_color_texture.image = b.image(1, 1, {vec4(0.5f)});
    int material = b.material(m);
    b.place(b.quad(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), material));
    b.place(b.quad(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), kUnset));
    FlatScene flat = test::flatten_quietly(b.scene);
    ASSERT_EQ(flat.materials.size(), 2u);
    EXPECT_EQ(flat.geometries[1].material, 1u);
    EXPECT_EQ(flat.materials[0].normal_texture, 0u);
    EXPECT_EQ(flat.texture_uses[0].image, 0u);
    const TextureUse& use = flat.texture_uses[flat.materials[0].base_color_texture];
    EXPECT_EQ(use.image, 1u);
}

// Three instances of two meshes with some emissive primitives.
SceneBuilder emitting_scene() {
    SceneBuilder b;
    int dark = b.material(test::lambertian(vec3(1)));
    int bright = b.material(test::emitter(vec3(3)));
    Material unlit = test::lambertian(vec3(0.5f));
    unlit.unlit = true;
    int flat_color = b.material(unlit);
    vec3 x(1, 0, 0), y(0, 1, 0);
    int mixed = b.mesh({b.quad_primitive(vec3(0), x, y, dark),
                        b.quad_primitive(vec3(0, 0, 1), x, y, bright),
                        b.quad_primitive(vec3(0, 0, 2), x, y, flat_color)});
    int plain = b.quad(vec3(0), x, y, dark);
    b.place(mixed);
    b.place(plain);
    b.place(mixed, glm::scale(kOne, vec3(2)));
    return b;
}

TEST(Flatten, EmittersAreFoundFromTheirHits) {
    SceneBuilder b = emitting_scene();
    FlatScene flat = test::flatten_quietly(b.scene);
    ASSERT_EQ(flat.emitters.size(), 8u);
    EXPECT_EQ(flat.geometries[0].emitter_offset, kNone);
    for (std::size_t i = 0; i < flat.emitters.size(); ++i) {
        const EmitterTriangle& e = flat.emitters[i];
        const InstanceData& instance = flat.instances[e.instance];
        const GeometryData& geometry = flat.geometries[instance.first_geometry + e.geometry];
        EXPECT_EQ(instance.first_emitter + geometry.emitter_offset + e.primitive, i);
    }
    // Power: pi A L; radiance 3 plus unlit 0.5; the second instance has four times the area.
    double per_area = std::numbers::pi * (3 + 0.5);
    EXPECT_NEAR(flat.emitter_power, per_area * (1 + 4), 1e-4);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(4 * flat.emitter_alias[i].pdf_self, flat.emitter_alias[i + 4].pdf_self, 1e-6f);
    EXPECT_NEAR(flat.emitter_alias[0].pdf_self, 1.5f / 3.5f / 5, 1e-6f);
}

TEST(Flatten, DoubleSidedEmittersHaveTwicePower) {
    double power[2];
    for (bool two_sided : {false, true}) {
        SceneBuilder b;
        Material m = test::emitter(vec3(1));
        m.double_sided = two_sided;
        b.place(b.quad(vec3(0), vec3(2, 0, 0), vec3(0, 3, 0), b.material(m)));
        power[two_sided ? 1 : 0] = test::flatten_quietly(b.scene).emitter_power;
    }
    EXPECT_NEAR(power[0], 6 * std::numbers::pi, 1e-4);
    EXPECT_NEAR(power[1], 2 * power[0], 1e-4);
}

TEST(Flatten, TexturedPowerIsTheMeanOfTheTexture) {
    SceneBuilder b;
    Material m = test::emitter(vec3(2));
    // Two of four columns are white: linear values 1 and 0.
    m.emissive_texture.image = b.image(4, 1, {vec4(0), vec4(1), vec4(1), vec4(0)});
    m.emissive_texture.wrap_u = m.emissive_texture.wrap_v = kWrapClamp;
    b.place(b.quad(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), b.material(m)));
    EXPECT_NEAR(test::flatten_quietly(b.scene).emitter_power, std::numbers::pi, 0.15);
}

void add_lights(SceneBuilder& b) {
    Light sun;
    sun.kind = kLightDirectional;
    b.light(sun);
    Light lamp;
    lamp.intensity = 7;
    b.light(lamp, glm::translate(kOne, vec3(0, 2, 0)));
    Light spot;
    spot.kind = kLightSpot;
    spot.inner_cone = 0.2f;
    spot.outer_cone = 0.5f;
    b.light(spot);
}

TEST(Flatten, SpotCoefficientsFollowTheExtension) {
    SceneBuilder b;
    add_lights(b);
    FlatScene flat = test::flatten_quietly(b.scene);
    ASSERT_EQ(flat.lights.size(), 3u);
    double scale = 1 / (std::cos(0.2) - std::cos(0.5));
    EXPECT_NEAR(double(flat.lights[2].spot_scale), scale, 1e-4 * scale);
    EXPECT_NEAR(double(flat.lights[2].spot_offset), -std::cos(0.5) * scale, 1e-4 * scale);
    EXPECT_EQ(flat.lights[2].direction, vec3(0, 0, -1));
    EXPECT_EQ(flat.lights[1].position, vec3(0, 2, 0));
    Diagnostics diagnostics;
    EXPECT_TRUE(flatten(b.scene, {}, {.punctual = false}, diagnostics).lights.empty());
}

void expect_whole(const LightRange& range) {
    // 32-bit random numbers within the range are remapped to all 32 bits, in order.
    SCOPED_TRACE(testing::Message() << range.begin << " to " << range.end);
    FlatScene nothing;
    LightHost host(nothing);
    double width = double(range.end) - double(range.begin), step = 4294967296.0 / width;
    EXPECT_EQ(host.stretch_choice(range, range.begin), 0u);
    EXPECT_GE(double(host.stretch_choice(range, range.end - 1)), 4294967295.0 - 2 * step - 1);
    for (int i = 0; i < 1000; ++i) {
        uint choice = range.begin + uint(width * i / 1000);
        EXPECT_NEAR(double(host.stretch_choice(range, choice)), width * i / 1000 * step,
                    2 * step + 2);
    }
}

TEST(Flatten, KindsOfLightShareTheSamples) {
    for (int present = 1; present < 8; ++present)
        for (uint strategy : {kStrategyMis, kStrategyLight, kStrategyBsdf}) {
            SceneBuilder b;
            if ((present & 1) != 0) b = emitting_scene();
            if ((present & 2) != 0) add_lights(b);
            FlatScene flat = test::flatten_quietly(
                b.scene,
                (present & 4) != 0 ? test::constant_environment(vec3(1)) : EnvironmentMap{});
            LightHost host(flat, strategy);
            const RenderParams& p = host.params;
            const LightRange ranges[] = {p.environment_range, p.punctual_range, p.emitter_range};
            const bool sampled = strategy != kStrategyBsdf;
            const bool expected[] = {(present & 4) != 0 && sampled, (present & 2) != 0,
                                     (present & 1) != 0 && sampled};
            double sum = 0;
            std::uint32_t end = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_EQ(ranges[k].pdf > 0, expected[k]) << present << " " << strategy << " " << k;
                if (!expected[k]) continue;
                sum += double(ranges[k].pdf);
                EXPECT_EQ(ranges[k].begin, end);
                EXPECT_NEAR(double(ranges[k].pdf),
                            (double(ranges[k].end) - double(ranges[k].begin)) / 4294967296.0, 1e-7);
                end = ranges[k].end;
                expect_whole(ranges[k]);
            }
            if (expected[0] || expected[1] || expected[2]) {
                EXPECT_NEAR(sum, 1, 1e-6);
                EXPECT_EQ(end, 0xffffffffu);
            }
        }
}

TEST(Camera, FramingShowsAllOfTheScene) {
    Bounds bounds;
    bounds.low = vec3(-3, 0, -1);
    bounds.high = vec3(5, 1, 2);
    for (float aspect : {0.5f, 1.0f, 2.0f}) {
        CameraData c = camera_framing(bounds, 0.8f, aspect);
        EXPECT_NEAR(dot(c.right, c.forward), 0.0f, 1e-6f);
        EXPECT_NEAR(dot(cross(c.right, c.up), -c.forward), 1.0f, 1e-5f);
        for (int i = 0; i < 8; ++i) {
            vec3 corner((i & 1) != 0 ? bounds.high.x : bounds.low.x,
                        (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                        (i & 4) != 0 ? bounds.high.z : bounds.low.z);
            vec3 d = corner - c.origin;
            float depth = dot(d, c.forward);
            EXPECT_GT(depth, 0.0f);
            EXPECT_LE(std::abs(dot(d, c.right)), depth * c.half_width);
            EXPECT_LE(std::abs(dot(d, c.up)), depth * c.half_height);
        }
    }
}

TEST(Camera, NodesLookDownTheirNegativeZ) {
    Camera camera;
    camera.yfov = 1;
    glm::mat4 world = glm::translate(glm::mat4(1), vec3(1, 2, 3));
    CameraData c = camera_from_node(camera, glm::scale(world, vec3(4)), 1.5f);
    EXPECT_EQ(c.origin, vec3(1, 2, 3));
    EXPECT_EQ(c.forward, vec3(0, 0, -1));
    EXPECT_NEAR(c.half_height, std::tan(0.5f), 1e-6f);
    EXPECT_NEAR(c.half_width, 1.5f * std::tan(0.5f), 1e-6f);
}

TEST(Flatten, PunctualLightsAreScaled) {
    test::SceneBuilder b;
    Light lamp;
    lamp.intensity = 683;
    b.light(lamp);
    EXPECT_EQ(test::flatten_quietly(b.scene).lights[0].color, vec3(683));
    const FlatScene scaled = test::flatten_quietly(b.scene, {}, {.punctual_scale = 0.5f});
    EXPECT_EQ(scaled.lights[0].color, vec3(341.5f));
}

}  // namespace
}  // namespace hm
