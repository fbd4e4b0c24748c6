#include "scene/tangents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace hm {
namespace {

Vertex vertex(vec3 position, vec3 normal, vec2 uv) {
    Vertex v{};
    v.position = position;
    v.normal = normal;
    v.uv0 = uv;
    return v;
}

// Two squares side by side, facing +z; the texture is mirrored at their common edge (1 and 2).
Primitive mirrored_squares() {
    Primitive p;
    p.has_normals = true;
    const vec3 up(0, 0, 1);
    for (const float x : {-1.0f, 0.0f, 1.0f}) {
        p.vertices.push_back(vertex(vec3(x, 0, 0), up, vec2(std::abs(x), 1)));
        p.vertices.push_back(vertex(vec3(x, 1, 0), up, vec2(std::abs(x), 0)));
    }
    p.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
    return p;
}

TEST(Tangents, VerticesAreSplitWhereTheTextureTurns) {
    Primitive p = mirrored_squares();
    for (std::size_t i = 0; i < p.vertices.size(); ++i)
        p.extras.push_back({vec2(float(i)), vec4(1)});
    const Primitive before = p;
    const std::vector<std::uint32_t> new_to_old = generate_tangents(p, {});
    EXPECT_TRUE(p.has_tangents);
    EXPECT_EQ(new_to_old, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 2, 3}));
    ASSERT_EQ(p.vertices.size(), 8u);
    ASSERT_EQ(p.extras.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(p.vertices[i].position, before.vertices[new_to_old[i]].position);
        EXPECT_EQ(p.vertices[i].normal, before.vertices[new_to_old[i]].normal);
        EXPECT_EQ(p.vertices[i].uv0, before.vertices[new_to_old[i]].uv0);
        EXPECT_EQ(p.extras[i].uv1.x, float(new_to_old[i]));
    }
    for (std::size_t t = 0; t < 4; ++t)
        for (int c = 0; c < 3; ++c) {
            const std::uint32_t v = p.triangles[t][c];
            EXPECT_EQ(new_to_old[v], before.triangles[t][c]);
            EXPECT_EQ(p.vertices[v].tangent, t < 2 ? vec4(-1, 0, 0, -1) : vec4(1, 0, 0, 1)) << t;
        }
}

TEST(Tangents, AVertexManyTrianglesNeedDifferentlyHasACopyForEach) {
    // Two thin triangles per direction: four tangents at one vertex, each for two triangles.
    Primitive p;
    p.has_normals = true;
    p.vertices.push_back(vertex(vec3(0), vec3(0, 0, 1), vec2(0)));
    for (int i = 0; i < 8; ++i) {
        const float a = 1.5707963f * float(i % 4);
        const vec3 along(std::cos(a), std::sin(a), 0), across(-along.y, along.x, 0);
        const auto first = std::uint32_t(p.vertices.size());
        p.vertices.push_back(vertex(along, vec3(0, 0, 1), vec2(1, 0)));
        p.vertices.push_back(vertex(along + 0.1f * across, vec3(0, 0, 1), vec2(1, 0.1f)));
        p.triangles.emplace_back(0u, first, first + 1);
    }
    generate_tangents(p, {});
    EXPECT_EQ(p.vertices.size(), 17u + 3u);
    for (std::size_t t = 0; t < 8; ++t) {
        const uvec3 triangle = p.triangles[t];
        const vec3 along = p.vertices[triangle.y].position;
        EXPECT_NEAR(dot(vec3(p.vertices[triangle.x].tangent), along), 1, 1e-6f);
        EXPECT_EQ(triangle.x, p.triangles[t % 4].x);
    }
}

TEST(Tangents, FlatFacesUseTheirOwnNormals) {
    // A roof of two squares: with shared normals at the ridge, tangents are averaged there; without
    // normals each side has its own tangents, and the ridge vertices are split.
    Primitive p;
    p.has_normals = true;
    for (const float x : {-1.0f, 0.0f, 1.0f})
        for (const float y : {0.0f, 1.0f})
            p.vertices.push_back(vertex(vec3(x, y, -std::abs(x)), vec3(0, 0, 1), vec2(x, 1 - y)));
    p.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
    Primitive flat = p;
    flat.has_normals = false;
    for (Vertex& v : flat.vertices)
        v.normal = vec3(0);
    generate_tangents(p, {});
    EXPECT_EQ(p.vertices.size(), 6u);
    EXPECT_NEAR(p.vertices[2].tangent.x, 1, 1e-6f);
    generate_tangents(flat, {});
    EXPECT_EQ(flat.vertices.size(), 8u);
    EXPECT_FALSE(flat.has_normals);
    const float half = std::sqrt(0.5f);
    for (std::size_t t = 0; t < 4; ++t)
        for (int c = 0; c < 3; ++c) {
            const vec4 tangent = flat.vertices[flat.triangles[t][c]].tangent;
            EXPECT_NEAR(tangent.x, half, 1e-6f);
            EXPECT_NEAR(tangent.z, t < 2 ? half : -half, 1e-6f);
            EXPECT_EQ(tangent.w, 1);
        }
}

TEST(Tangents, TheSecondSetOfCoordinatesCounts) {
    Primitive p = mirrored_squares();
    for (const Vertex& v : p.vertices)
        p.extras.push_back({vec2(v.position.y, v.position.x), vec4(1)});
    generate_tangents(p, {.uv_set = 1});
    EXPECT_EQ(p.vertices.size(), 6u);
    for (const Vertex& v : p.vertices)
        EXPECT_EQ(v.tangent, vec4(0, 1, 0, 1));
}

TEST(Tangents, WithoutCoordinatesThereIsADirectionStill) {
    Primitive p = mirrored_squares();
    generate_tangents(p, {.uv_set = 1});
    EXPECT_EQ(p.vertices.size(), 6u);
    for (const Vertex& v : p.vertices)
        EXPECT_EQ(v.tangent, vec4(1, 0, 0, 1));
}

TEST(Tangents, AreMadeWhereAMaterialMapsNormalsAndAFileBringsNone) {
    Scene scene;
    scene.materials.resize(2);
    scene.materials[1].normal_texture.image = 0;
    Primitive p = mirrored_squares();
    Mesh mesh;
    mesh.primitives.assign(4, p);
    mesh.primitives[1].material = 0;
    mesh.primitives[2].material = 1;
    mesh.primitives[3].material = 1;
    mesh.primitives[3].has_tangents = true;
    scene.meshes = {mesh};
    prepare_tangents(scene);
    const std::vector<Primitive>& made = scene.meshes[0].primitives;
    EXPECT_FALSE(made[0].has_tangents);
    EXPECT_FALSE(made[1].has_tangents);
    EXPECT_TRUE(made[2].has_tangents);
    EXPECT_EQ(made[2].vertices.size(), 8u);
    EXPECT_EQ(made[3].vertices.size(), 6u);
    EXPECT_EQ(made[3].vertices[0].tangent, vec4(0));
}

TEST(Tangents, DeformationsFollowTheSplitVertices) {
    Scene scene;
    scene.materials.resize(1);
    scene.materials[0].normal_texture.image = 0;
    Primitive p = mirrored_squares();
    p.material = 0;
    auto d = std::make_shared<Deformation>();
    d->rest = p.vertices;
    d->targets.resize(1);
    d->targets[0].positions = {{1, vec3(1)}, {3, vec3(3)}, {4, vec3(4)}};
    d->influences = 2;
    for (std::uint16_t i = 0; i < 12; ++i) {
        d->joints.push_back(i);
        d->weights.push_back(float(i));
    }
    p.deformation = d;
    Mesh mesh;
    mesh.primitives = {p};
    scene.meshes = {mesh};
    prepare_tangents(scene);
    // Vertices 2 and 3 were copied, to 6 and 7.
    const Primitive& split = scene.meshes[0].primitives[0];
    const Deformation& made = *split.deformation;
    ASSERT_EQ(made.rest.size(), 8u);
    EXPECT_EQ(made.rest[6].tangent, split.vertices[6].tangent);
    ASSERT_EQ(made.targets[0].positions.size(), 4u);
    EXPECT_EQ(made.targets[0].positions[3].vertex, 7u);
    EXPECT_EQ(made.targets[0].positions[3].value, vec3(3));
    ASSERT_EQ(made.joints.size(), 16u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(made.joints[12 + i], 4 + i);
        EXPECT_EQ(made.weights[12 + i], float(4 + i));
    }
}

}  // namespace
}  // namespace hm
