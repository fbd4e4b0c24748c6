// Which finite lights lie on surfaces: within the error of hits, over the triangle, in any frame.
#include "scene/light_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/scenes.h"

namespace hm {
namespace {

using test::SceneBuilder;

Light lamp(std::uint32_t kind = kLightPoint) {
    Light light;
    light.kind = kind;
    return light;
}

glm::mat4 at(vec3 p) {
    return glm::translate(glm::mat4(1), p);
}

// A ceiling of half extent 1, in the plane z = 0 of a frame.
void add_ceiling(SceneBuilder& b, const glm::mat4& frame) {
    b.place(b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0),
                   b.material(test::lambertian(vec3(0.5f)))),
            frame);
}

LightData light_at(const glm::mat4& ceiling, vec3 world, std::uint32_t kind = kLightPoint) {
    SceneBuilder b;
    add_ceiling(b, ceiling);
    b.light(lamp(kind), at(world));
    return test::flatten_quietly(b.scene).lights.at(0);
}

TEST(LightSurfaces, ALampOnATriangleHasItsNormalAndError) {
    for (const float size : {1e-6f, 1.0f, 1e6f})
        for (const float away : {0.0f, 30.0f}) {
            glm::mat4 frame = at(vec3(1, 2, -3) * (away * size));
            frame = glm::rotate(frame, 0.4f, vec3(1, 2, 0.5f));
            frame = glm::scale(frame, vec3(size));
            const vec3 normal = normalize(vec3(frame[2]));
            for (const vec3 p : {vec3(0.3f, 0.1f, 0), vec3(0), vec3(-0.9f, 0.8f, 0)}) {
                const vec3 world = frame * vec4(p, 1);
                for (const std::uint32_t kind : {kLightPoint, kLightSpot}) {
                    const LightData light = light_at(frame, world, kind);
                    EXPECT_GT(light.surface_error, 0) << size << " " << away;
                    EXPECT_LT(light.surface_error, 1e-4f * size * (1 + away));
                    EXPECT_NEAR(std::abs(dot(light.surface_normal, normal)), 1, 1e-5f);
                    // Just outside of the error.
                    const vec3 off = normal * (1.5f * light.surface_error);
                    EXPECT_EQ(light_at(frame, world + off, kind).surface_error, 0);
                }
                EXPECT_EQ(light_at(frame, world, kLightDirectional).surface_error, 0);
            }
            const vec3 beside = frame * vec4(1.01f, 0.2f, 0, 1);
            EXPECT_EQ(light_at(frame, beside).surface_error, 0);
        }
}

// Rays from any side of an edge must pass, so no single normal serves.
TEST(LightSurfaces, OnAnEdgeThereIsNoNormal) {
    SceneBuilder b;
    add_ceiling(b, glm::mat4(1));
    add_ceiling(b, glm::rotate(at(vec3(0, 1, 0)), 1.0f, vec3(1, 0, 0)));
    b.light(lamp(), at(vec3(0.3f, 1, 0)));
    const LightData light = test::flatten_quietly(b.scene).lights.at(0);
    EXPECT_GT(light.surface_error, 0);
    EXPECT_EQ(light.surface_normal, vec3(0));
}

// A grid of lamps on a finely tessellated floor, drawn by two instances. Comparing each lamp with
// each triangle would take minutes.
TEST(LightSurfaces, ManyLampsOnManyTriangles) {
    constexpr int kCells = 700, kLamps = 100;
    SceneBuilder b;
    Primitive floor = b.quad_primitive(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0),
                                       b.material(test::lambertian(vec3(0.5f))));
    const Vertex vertex = floor.vertices[0];
    floor.vertices.clear();
    floor.triangles.clear();
    for (int i = 0; i <= kCells; ++i)
        for (int j = 0; j <= kCells; ++j) {
            floor.vertices.push_back(vertex);
            floor.vertices.back().position = vec3(float(i), float(j), 0) / float(kCells);
        }
    for (uint i = 0; i < kCells; ++i)
        for (uint j = 0; j < kCells; ++j) {
            const uint k = i * (kCells + 1) + j;
            floor.triangles.push_back({k, k + kCells + 1, k + 1});
            floor.triangles.push_back({k + 1, k + kCells + 1, k + kCells + 2});
        }
    const int mesh = b.mesh({floor});
    b.place(mesh);
    b.place(mesh, at(vec3(0, 0, 5)));
    for (int i = 0; i < kLamps; ++i)
        for (int j = 0; j < kLamps; ++j)
            b.light(lamp(), at(vec3((float(i) + 0.5f) / kLamps, (float(j) + 0.5f) / kLamps,
                                    (i + j) % 2 == 0 ? 5.0f : 1.0f)));
    const FlatScene flat = test::flatten_quietly(b.scene);
    for (const LightData& light : flat.lights)
        ASSERT_EQ(light.surface_error > 0, light.position.z == 5) << light.position.x;
}

}  // namespace
}  // namespace hm
