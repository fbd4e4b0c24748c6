// Punctual lights on a Lambertian plane: no noise. The only deviation from the closed form is that
// shading points are offset above the floor by a rounding error.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/pictures.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Shot;
using test::Studio;

const glm::mat4 kOne(1);
const vec3 kAlbedo(0.8f, 0.5f, 0.2f);
constexpr float kPiFloat = std::numbers::pi_v<float>;

SceneBuilder floor_scene() {
    SceneBuilder b;
    b.place(b.quad(vec3(-5, 0, 5), vec3(10, 0, 0), vec3(0, 0, -10),
                   b.material(test::lambertian(kAlbedo))));
    return b;
}

// The transform of a light at `position` that shines along `axis`.
glm::mat4 aimed(vec3 position, vec3 axis) {
    vec3 z = -normalize(axis);
    vec3 x = normalize(cross(std::abs(z.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0), z));
    vec3 y = cross(z, x);
    return glm::mat4(vec4(x, 0), vec4(y, 0), vec4(z, 0), vec4(position, 1));
}

void expect_floor(SceneBuilder& b, vec3 point, vec3 expected, uint strategy = kStrategyMis) {
    Studio studio(b.scene);
    CameraData camera = test::point_camera(point, vec3(0.3f, 0.8f, 0.4f));
    Shot shot{.width = 2, .height = 2, .samples = 16, .strategy = strategy};
    for (const vec3& p : studio.render(camera, shot).pixels)
        EXPECT_LT(length(p - expected), 3e-4f * length(expected) + 1e-7f)
            << p.x << " instead of " << expected.x;
}

TEST(Lights, DirectionalIsIrradianceTimesAlbedoOverPi) {
    for (float angle : {0.0f, 0.5f, 1.2f, 1.55f, 2.0f})
        for (uint strategy : {kStrategyMis, kStrategyLight, kStrategyBsdf}) {
            SceneBuilder b = floor_scene();
            Light sun;
            sun.kind = kLightDirectional;
            sun.color = vec3(1, 0.5f, 0.25f);
            sun.intensity = 4;
            b.light(sun, aimed(vec3(0), vec3(std::sin(angle), -std::cos(angle), 0)));
            float cosine = std::max(0.0f, std::cos(angle));
            expect_floor(b, vec3(0.3f, 0, -0.2f), kAlbedo * sun.color * (4 * cosine / kPiFloat),
                         strategy);
        }
}

TEST(Lights, PointFollowsTheInverseSquareAndItsRange) {
    for (float range : {0.0f, 4.0f})
        for (float x : {0.0f, 1.0f, 3.0f}) {
            SceneBuilder b = floor_scene();
            Light lamp;
            lamp.intensity = 10;
            lamp.range = range;
            b.light(lamp, glm::translate(kOne, vec3(0.2f, 1.5f, -0.1f)));
            float d2 = x * x + 1.5f * 1.5f;
            float ratio2 = range > 0 ? d2 / (range * range) : 0;
            float window = std::max(0.0f, 1 - ratio2 * ratio2);
            float cosine = 1.5f / std::sqrt(d2);
            expect_floor(b, vec3(0.2f + x, 0, -0.1f),
                         kAlbedo * (10 * window * cosine / (kPiFloat * d2)));
        }
}

TEST(Lights, SpotHasACoreAPenumbraAndAnEdge) {
    const float inner = 0.25f, outer = 0.6f;
    for (float angle : {0.0f, 0.2f, 0.3f, 0.45f, 0.55f, 0.65f, 1.0f}) {
        SceneBuilder b = floor_scene();
        Light spot;
        spot.kind = kLightSpot;
        spot.intensity = 5;
        spot.inner_cone = inner;
        spot.outer_cone = outer;
        b.light(spot, aimed(vec3(0, 2, 0), vec3(0, -1, 0)));
        float x = 2 * std::tan(angle), d2 = x * x + 4, cosine = 2 / std::sqrt(d2);
        float t = (std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
        t = std::clamp(t, 0.0f, 1.0f);
        expect_floor(b, vec3(x, 0, 0), kAlbedo * (5 * t * t * cosine / (kPiFloat * d2)));
    }
}

TEST(Lights, TwoLightsAddUp) {
    SceneBuilder b = floor_scene();
    Light sun;
    sun.kind = kLightDirectional;
    b.light(sun, aimed(vec3(0), vec3(0, -1, 0)));
    Light lamp;
    lamp.intensity = 2;
    b.light(lamp, glm::translate(kOne, vec3(0, 1, 0)));
    Studio studio(b.scene);
    test::expect_radiance(studio, test::point_camera(vec3(0), vec3(0.3f, 0.8f, 0.4f)),
                          {.samples = 256}, kAlbedo * (3 / kPiFloat));
}

TEST(Lights, KindsOfLightAddUp) {
    // A sun and a sky together: each is selected for a part of the samples.
    SceneBuilder b = floor_scene();
    Light sun;
    sun.kind = kLightDirectional;
    b.light(sun, aimed(vec3(0), vec3(0, -1, 0)));
    Studio studio(b.scene, test::constant_environment(vec3(0.5f)));
    for (uint strategy : {kStrategyMis, kStrategyLight, kStrategyBsdf})
        test::expect_radiance(studio, test::point_camera(vec3(0), vec3(0.3f, 0.8f, 0.4f)),
                              {.samples = 256, .strategy = strategy},
                              kAlbedo * (1 / kPiFloat + 0.5f));
}

TEST(Lights, ThingsBetweenCastShadows) {
    SceneBuilder b = floor_scene();
    int black = b.material(test::lambertian(vec3(0)));
    b.place(b.quad(vec3(-0.5f, 1, -0.5f), vec3(1, 0, 0), vec3(0, 0, 1), black));
    Light sun;
    sun.kind = kLightDirectional;
    b.light(sun, aimed(vec3(0), vec3(0, -1, 0)));
    Studio studio(b.scene);
    Shot shot{.width = 2, .height = 2, .samples = 4};
    for (vec3 point : {vec3(0), vec3(0.45f, 0, 0.45f)})
        for (const vec3& p :
             studio.render(test::point_camera(point, vec3(1, 0.5f, 1)), shot).pixels)
            EXPECT_EQ(p, vec3(0));
    for (const vec3& p :
         studio.render(test::point_camera(vec3(0.55f, 0, 0), vec3(1, 0.5f, 1)), shot).pixels)
        EXPECT_NEAR(p.x, kAlbedo.x / kPiFloat, 1e-5f);
}

}  // namespace
}  // namespace hm
