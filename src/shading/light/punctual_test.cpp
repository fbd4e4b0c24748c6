// Punctual lights against KHR_lights_punctual, and camera rays.
#include "shading/light/punctual.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shading/camera.h"

namespace hm {
namespace {

LightData point_light(float range) {
    LightData light{};
    light.kind = kLightPoint;
    light.position = vec3(1, 2, 3);
    light.color = vec3(10, 20, 30);
    light.range = range;
    return light;
}

TEST(Lights, InverseSquare) {
    for (float d : {0.01f, 0.5f, 1.0f, 4.0f, 1000.0f}) {
        PunctualSample s;
        sample_punctual(point_light(0), vec3(1, 2 - d, 3), s);
        EXPECT_NEAR(s.irradiance.y * d * d, 20.0f, 1e-3f);
        EXPECT_NEAR(s.distance, d, 1e-4f * d);
        EXPECT_NEAR(s.wi.y, 1.0f, 1e-6f);
    }
}

TEST(Lights, RangeWindowsToZero) {
    const float range = 5;
    for (float d : {0.5f, 1.0f, 2.5f, 4.0f, 4.9f}) {
        double window = 1 - std::pow(double(d) / double(range), 4);
        EXPECT_NEAR(double(punctual_falloff(d * d, range)), window / (double(d) * double(d)),
                    1e-5 / double(d * d));
    }
    EXPECT_EQ(punctual_falloff(25, range), 0.0f);
    EXPECT_EQ(punctual_falloff(26, range), 0.0f);
    EXPECT_EQ(punctual_falloff(4, 0), 0.25f);
}

TEST(Lights, SpotConeIsTheExtensionsFormula) {
    const double inner = 0.3, outer = 0.7;
    LightData light = point_light(0);
    light.kind = kLightSpot;
    light.direction = vec3(0, 0, -1);
    light.spot_scale = float(1 / (std::cos(inner) - std::cos(outer)));
    light.spot_offset = float(-std::cos(outer)) * light.spot_scale;
    for (double angle : {0.0, 0.2, 0.299, 0.35, 0.5, 0.65, 0.701, 1.5, 3.0}) {
        vec3 p = light.position + 2.0f * vec3(float(std::sin(angle)), 0, -float(std::cos(angle)));
        PunctualSample s;
        sample_punctual(light, p, s);
        double t = (std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
        t = std::clamp(t, 0.0, 1.0);
        EXPECT_NEAR(double(s.irradiance.x), 10.0 / 4 * t * t, 1e-5) << angle;
    }
}

// The shadow ray ends in front of the surface, by its error along the normal, whatever the angle;
// on an edge of several surfaces by 64 times that. The light itself stays what it is.
TEST(Lights, OnASurfaceTheShadowRayEndsInFrontOfIt) {
    LightData light = point_light(0);
    light.surface_normal = vec3(0, 1, 0);
    light.surface_error = 1e-3f;
    for (float cosine : {1.0f, 0.5f, 0.1f, 0.02f}) {
        const vec3 to_light(std::sqrt(1 - cosine * cosine), cosine, 0);
        PunctualSample s, plain;
        sample_punctual(light, light.position - 2.0f * to_light, s);
        sample_punctual(point_light(0), light.position - 2.0f * to_light, plain);
        EXPECT_NEAR((plain.distance - s.distance) * cosine, 1e-3f, 1e-5f) << cosine;
        EXPECT_EQ(s.irradiance, plain.irradiance);
        light.surface_normal = vec3(0);
        sample_punctual(light, light.position - 2.0f * to_light, s);
        EXPECT_NEAR(plain.distance - s.distance, 64e-3f, 5e-4f);
        light.surface_normal = vec3(0, 1, 0);
    }
    PunctualSample s;
    sample_punctual(light, light.position - vec3(0, 1e-4f, 0), s);
    EXPECT_EQ(s.distance, 0.0f);
}

TEST(Lights, DirectionalNeverFades) {
    LightData light{};
    light.kind = kLightDirectional;
    light.direction = vec3(0, -1, 0);
    light.color = vec3(3);
    light.range = 1;
    PunctualSample s;
    sample_punctual(light, vec3(1e4f), s);
    EXPECT_EQ(s.irradiance, vec3(3));
    EXPECT_EQ(s.wi, vec3(0, 1, 0));
    EXPECT_EQ(s.distance, kInfinity);
}

CameraData test_camera(uint kind) {
    CameraData c{};
    c.origin = vec3(1, 2, 3);
    c.right = vec3(0, 0, 1);
    c.up = vec3(0, 1, 0);
    c.forward = vec3(1, 0, 0);
    c.half_height = 0.5f;
    c.half_width = 0.75f;
    c.focus_distance = 4;
    c.kind = kind;
    return c;
}

TEST(Camera, PinholeCentreAndCorners) {
    CameraData c = test_camera(kCameraPerspective);
    CameraRay ray;
    make_camera_ray(c, vec2(0.5f), 0, 0, ray);
    EXPECT_EQ(ray.origin, c.origin);
    EXPECT_EQ(ray.direction, c.forward);
    make_camera_ray(c, vec2(0, 0), 0.3f, 0.6f, ray);  // upper left
    EXPECT_LT(length(ray.direction - normalize(vec3(1, 0.5f, -0.75f))), 1e-6f);
    make_camera_ray(c, vec2(1, 1), 0.3f, 0.6f, ray);  // lower right
    EXPECT_LT(length(ray.direction - normalize(vec3(1, -0.5f, 0.75f))), 1e-6f);
    make_camera_ray(c, vec2(0.5f, 0), 0, 0, ray);  // half the vertical field of view
    EXPECT_NEAR(std::atan2(ray.direction.y, ray.direction.x), std::atan(0.5f), 1e-6f);
}

TEST(Camera, OrthographicRaysAreParallel) {
    CameraData c = test_camera(kCameraOrthographic);
    CameraRay ray;
    make_camera_ray(c, vec2(0, 1), 0, 0, ray);
    EXPECT_EQ(ray.direction, c.forward);
    EXPECT_LT(length(ray.origin - (c.origin + vec3(0, -0.5f, -0.75f))), 1e-6f);
}

TEST(Camera, LensRaysMeetInThePlaneOfFocus) {
    for (uint kind : {kCameraPerspective, kCameraOrthographic}) {
        CameraData c = test_camera(kind);
        CameraRay pinhole;
        make_camera_ray(c, vec2(0.2f, 0.9f), 0, 0, pinhole);
        vec3 focus = pinhole.origin +
                     pinhole.direction * (c.focus_distance / dot(pinhole.direction, c.forward));
        c.lens_radius = 0.25f;
        float farthest = 0;
        for (int i = 0; i < 256; ++i) {
            CameraRay ray;
            make_camera_ray(c, vec2(0.2f, 0.9f), float(i / 16) / 16, float(i % 16) / 16, ray);
            float t = c.focus_distance / dot(ray.direction, c.forward);
            EXPECT_LT(length(ray.origin + ray.direction * t - focus), 2e-6f);
            EXPECT_NEAR(length(ray.direction), 1.0f, 1e-6f);
            vec3 lens = ray.origin - pinhole.origin;
            EXPECT_NEAR(dot(lens, c.forward), 0.0f, 1e-6f);
            EXPECT_LE(length(lens), 0.25f + 1e-6f);
            farthest = std::max(farthest, length(lens));
        }
        EXPECT_GT(farthest, 0.23f);
    }
}

}  // namespace
}  // namespace hm
