// Environments and emissive surfaces against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/pictures.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::expect_radiance;
using test::SceneBuilder;
using test::Shot;
using test::Studio;

const glm::mat4 kOne(1);
constexpr uint kStrategies[] = {kStrategyMis, kStrategyLight, kStrategyBsdf};

const char* name_of(uint strategy) {
    return strategy == kStrategyMis ? "MIS" : strategy == kStrategyLight ? "light" : "BSDF";
}

TEST(Emission, ConvexDiffuseBodyInAConstantSkyReadsAlbedoTimesSky) {
    const vec3 albedo(0.7f, 0.5f, 0.2f), sky(1, 2, 3);
    SceneBuilder b;
    int sphere = b.sphere(32, b.material(test::lambertian(albedo)));
    b.scene.meshes[0].primitives[0].has_normals = false;  // flat facets: truly convex
    b.place(sphere);
    Studio studio(b.scene, test::constant_environment(sky));
    CameraData camera = test::flat_camera(vec3(0), vec3(1, 2, 3), 0.6f);
    camera.origin = camera.origin * 3.0f;
    // Every BSDF sample hits the same sky: each pixel is free of noise.
    for (uint bounces : {0u, 1u, 4u}) {
        Shot shot{.samples = 4, .bounces = bounces, .strategy = kStrategyBsdf};
        for (const vec3& p : studio.render(camera, shot).pixels)
            EXPECT_LT(length(p - albedo * sky), 1e-4f);
    }
    for (uint strategy : {kStrategyMis, kStrategyLight}) {
        SCOPED_TRACE(name_of(strategy));
        expect_radiance(studio, camera, {.samples = 256, .strategy = strategy}, albedo * sky);
    }
}

TEST(Emission, ClosedBoxReadsEmissionOverOneMinusAlbedo) {
    for (float albedo : {0.5f, 0.9f}) {
        SCOPED_TRACE(albedo);
        const vec3 emission(1, 0.5f, 0.25f);
        SceneBuilder b;
        Material m = test::lambertian(vec3(albedo));
        m.emissive_factor = emission;
        b.place(test::add_cube(b, true, b.material(m)));
        Studio studio(b.scene);
        CameraData camera = test::flat_camera(vec3(0.2f, -0.1f, 0.3f), vec3(1, 2, 3), 0.3f);
        camera.origin = vec3(0.2f, -0.1f, 0.3f);
        for (uint strategy : {kStrategyMis, kStrategyBsdf}) {
            SCOPED_TRACE(name_of(strategy));
            Shot shot{.samples = 96, .bounces = 0, .strategy = strategy};
            expect_radiance(studio, camera, shot, emission / (1 - albedo), 0.015);
        }
        // Limited to three bounces: the first four terms of the series.
        float a = albedo;
        Shot cut{.samples = 64, .bounces = 3, .strategy = kStrategyBsdf};
        expect_radiance(studio, camera, cut, emission * (1 + a + a * a + a * a * a), 0.015);
    }
}

// Form factor of a parallel rectangle with sides x and y and one corner directly above a horizontal
// receiver at height 1: its fraction of the cosine-weighted hemisphere (textbook formula).
double corner_factor(double x, double y) {
    double rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
    return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * std::numbers::pi);
}

const vec3 kFloorAlbedo(0.8f, 0.6f, 0.4f);
const vec3 kLamp(3, 2, 1);

// A floor at y = 0, and a lamp at y = 1 with x from -0.5 to 1 and z from -1 to 0.25, facing down or
// up.
SceneBuilder lamp_over_floor(const Material& lamp, bool faces_down) {
    SceneBuilder b;
    b.place(b.quad(vec3(-2, 0, 2), vec3(4, 0, 0), vec3(0, 0, -4),
                   b.material(test::lambertian(kFloorAlbedo))));
    vec3 x(1.5f, 0, 0), z(0, 0, 1.25f), corner(-0.5f, 1, -1);
    int material = b.material(lamp);
    b.place(faces_down ? b.quad(corner, x, z, material) : b.quad(corner, z, x, material));
    return b;
}

double lamp_factor() {
    return corner_factor(1, 0.25) + corner_factor(1, 1) + corner_factor(0.5, 0.25) +
           corner_factor(0.5, 1);
}

CameraData floor_camera() {
    return test::point_camera(vec3(0), vec3(0.5f, 0.5f, 0.7f));
}

TEST(Emission, LampOverAFloorHasItsFormFactor) {
    for (bool two_sided : {false, true})
        for (bool faces_down : {false, true})
            for (uint strategy : kStrategies) {
                SCOPED_TRACE(testing::Message() << name_of(strategy) << " two-sided " << two_sided
                                                << " down " << faces_down);
                Material m = test::emitter(kLamp);
                m.double_sided = two_sided;
                SceneBuilder b = lamp_over_floor(m, faces_down);
                Studio studio(b.scene);
                float factor = faces_down || two_sided ? float(lamp_factor()) : 0.0f;
                expect_radiance(studio, floor_camera(), {.samples = 64, .strategy = strategy},
                                kFloorAlbedo * kLamp * factor, 0.02);
            }
}

TEST(Emission, MirroredLampStillFacesDown) {
    for (uint strategy : kStrategies) {
        SceneBuilder b = lamp_over_floor(test::emitter(kLamp), true);
        // Mirrored in x and moved back to its original position.
        glm::mat4 mirror =
            glm::translate(kOne, vec3(0.5f, 0, 0)) * glm::scale(kOne, vec3(-1, 1, 1));
        b.scene.nodes[1].local = mirror;
        Studio studio(b.scene);
        SCOPED_TRACE(name_of(strategy));
        expect_radiance(studio, floor_camera(), {.samples = 64, .strategy = strategy},
                        kFloorAlbedo * kLamp * float(lamp_factor()), 0.02);
    }
}

TEST(Emission, TexturedLampShinesByItsTexels) {
    // Stripes across the lamp: the left half of the texture is x < 0.25.
    const double left = corner_factor(0.5, 0.25) + corner_factor(0.5, 1) +
                        corner_factor(0.25, 0.25) + corner_factor(0.25, 1);
    for (uint strategy : kStrategies) {
        SceneBuilder b;
        Material m = test::emitter(kLamp);
        m.emissive_texture.image = b.image(2, 1, {vec4(1), vec4(0, 1, 0, 1)});
        m.emissive_texture.filter_mode = kFilterNearest;
        SceneBuilder scene = lamp_over_floor(m, true);
        scene.scene.images = b.scene.images;
        Studio studio(scene.scene);
        SCOPED_TRACE(name_of(strategy));
        const vec3 factor{float(left), float(lamp_factor()), float(left)};
        expect_radiance(studio, floor_camera(), {.samples = 128, .strategy = strategy},
                        kFloorAlbedo * kLamp * factor, 0.02);
    }
}

TEST(Emission, CoveredLampsShineThroughTheirAlpha) {
    struct Case {
        uint mode;
        float alpha, coverage;
    };
    for (Case c : {Case{kAlphaBlend, 0.5f, 0.5f}, Case{kAlphaMask, 0.6f, 1.0f},
                   Case{kAlphaMask, 0.4f, 0.0f}, Case{kAlphaBlend, 0.0f, 0.0f}})
        for (uint strategy : kStrategies) {
            SCOPED_TRACE(testing::Message()
                         << name_of(strategy) << " alpha " << c.alpha << " mode " << c.mode);
            Material m = test::emitter(kLamp);
            m.alpha_mode = c.mode;
            m.base_color.w = c.alpha;
            SceneBuilder b = lamp_over_floor(m, true);
            Studio studio(b.scene);
            expect_radiance(studio, floor_camera(), {.samples = 128, .strategy = strategy},
                            kFloorAlbedo * kLamp * (c.coverage * float(lamp_factor())), 0.02);
        }
}

TEST(Emission, UnlitSurfacesShowTheirColourAndShineWithIt) {
    Material m = test::lambertian(vec3(0.9f, 0.5f, 0.3f));
    m.unlit = true;
    for (uint strategy : kStrategies) {
        SceneBuilder b = lamp_over_floor(m, true);
        Light sun;
        sun.kind = kLightDirectional;
        b.light(sun, glm::rotate(kOne, 1.0f, vec3(1, 0, 0)));  // lights only the back of the floor
        Studio studio(b.scene, {}, {.punctual = false});
        SCOPED_TRACE(name_of(strategy));
        expect_radiance(studio, floor_camera(), {.samples = 64, .strategy = strategy},
                        kFloorAlbedo * vec3(m.base_color) * float(lamp_factor()), 0.02);
        Studio lit(b.scene, test::constant_environment(vec3(5)));
        CameraData below = test::point_camera(vec3(0.1f, 1, -0.2f), vec3(0.1f, -0.4f, 0.2f));
        for (const vec3& p : lit.render(below, {.samples = 4, .bounces = 3}).pixels)
            EXPECT_EQ(p, vec3(m.base_color));
    }
}

TEST(Emission, BackgroundsAreSeenOnlyStraight) {
    SceneBuilder b;
    b.place(b.quad(vec3(-1, 0, 1), vec3(2, 0, 0), vec3(0, 0, -2),
                   b.material(test::lambertian(vec3(0.5f)))));
    Studio studio(b.scene, test::constant_environment(vec3(2)));
    CameraData camera = test::flat_camera(vec3(0), vec3(0, 1, 0), 2);
    for (uint background : {kBackgroundEnvironment, kBackgroundTransparent}) {
        Shot shot{.samples = 4, .strategy = kStrategyBsdf, .background = background};
        test::Picture p = studio.render(camera, shot);
        bool transparent = background == kBackgroundTransparent;
        EXPECT_NEAR(p.pixels[0].x, transparent ? 0.0f : 2.0f, 1e-5f);
        EXPECT_EQ(p.alpha[0], transparent ? 0.0f : 1.0f);
        EXPECT_NEAR(p.pixels[8 * 4 + 4].x, 1.0f, 1e-5f);
        EXPECT_EQ(p.alpha[8 * 4 + 4], 1.0f);
    }
}

}  // namespace
}  // namespace hm
