// Tangents against the reference implementation (tests/tangents/make_fixture.mjs), and degenerate
// input.
#include "scene/tangent_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "base/files.h"

namespace hm {
namespace {

struct TexturedMesh {
    std::vector<SurfacePoint> points;
    std::vector<uvec3> triangles;
    std::vector<vec4> expected;  // per corner; w in glTF's convention
};

class FixtureReader {
  public:
    explicit FixtureReader(ByteArray bytes) : bytes_(std::move(bytes)) {}

    std::uint32_t number() {
        std::uint32_t value = 0;
        copy(&value, sizeof value);
        return value;
    }
    std::string text() {
        std::string value(number(), ' ');
        copy(value.data(), value.size());
        return value;
    }
    template <class T>
    std::vector<T> values(std::size_t count) {
        std::vector<T> out(count);
        copy(out.data(), count * sizeof(T));
        return out;
    }

  private:
    void copy(void* to, std::size_t size) {
        ASSERT_LE(at_ + size, bytes_.size());
        std::memcpy(to, bytes_.data() + at_, size);
        at_ += size;
    }
    ByteArray bytes_;
    std::size_t at_ = 0;
};

std::map<std::string, TexturedMesh> read_fixture() {
    std::map<std::string, TexturedMesh> meshes;
    const char* root = std::getenv("HIMALAYA_SOURCE_DIR");
    auto bytes =
        read_file(std::string(root == nullptr ? "." : root) + "/tests/tangents/fixture.bin");
    if (!bytes) return meshes;
    FixtureReader reader(std::move(*bytes));
    const std::uint32_t count = reader.number();
    for (std::uint32_t i = 0; i < count; ++i) {
        TexturedMesh& mesh = meshes[reader.text()];
        const std::uint32_t points = reader.number(), triangles = reader.number();
        mesh.points = reader.values<SurfacePoint>(points);
        mesh.triangles = reader.values<uvec3>(triangles);
        mesh.expected = reader.values<vec4>(3 * std::size_t(triangles));
    }
    return meshes;
}

TEST(TangentSpace, AgreesWithTheReferenceAtEveryCorner) {
    const auto meshes = read_fixture();
    ASSERT_EQ(meshes.size(), 9u);
    for (const auto& [name, mesh] : meshes) {
        const std::vector<vec4> tangents = corner_tangents(mesh.points, mesh.triangles);
        ASSERT_EQ(tangents.size(), mesh.expected.size()) << name;
        for (std::size_t c = 0; c < tangents.size(); ++c) {
            // The reference uses float: its directions are accurate to a few 1e-7 times the
            // cancellation in the mean, which is small for these meshes.
            EXPECT_GT(dot(vec3(tangents[c]), vec3(mesh.expected[c])), 0.99999f)
                << name << " corner " << c;
            EXPECT_EQ(tangents[c].w, mesh.expected[c].w) << name << " corner " << c;
        }
    }
}

std::vector<SurfacePoint> unit_square() {
    const vec3 up(0, 0, 1);
    return {{vec3(0, 0, 0), up, vec2(0, 1)},
            {vec3(1, 0, 0), up, vec2(1, 1)},
            {vec3(1, 1, 0), up, vec2(1, 0)},
            {vec3(0, 1, 0), up, vec2(0, 0)}};
}

const std::vector<uvec3> kSquare = {{0, 1, 2}, {0, 2, 3}};

TEST(TangentSpace, AnUprightTexturePointsUp) {
    // v increases downwards, so cross(normal, tangent) * w points up in the image.
    for (const vec4& t : corner_tangents(unit_square(), kSquare))
        EXPECT_EQ(t, vec4(1, 0, 0, 1));
    std::vector<SurfacePoint> mirrored = unit_square();
    for (SurfacePoint& p : mirrored)
        p.uv.x = -p.uv.x;
    for (const vec4& t : corner_tangents(mirrored, kSquare))
        EXPECT_EQ(t, vec4(-1, 0, 0, -1));
}

TEST(TangentSpace, EqualVerticesAreOneWhateverTheirIndices) {
    const auto meshes = read_fixture();
    ASSERT_FALSE(meshes.empty());
    const TexturedMesh& mesh = meshes.at("torus");
    std::vector<SurfacePoint> points;
    std::vector<uvec3> triangles;
    for (const uvec3& t : mesh.triangles) {
        const auto first = std::uint32_t(points.size());
        for (const std::uint32_t v : {t.x, t.y, t.z})
            points.push_back(mesh.points[v]);
        triangles.emplace_back(first, first + 1, first + 2);
    }
    EXPECT_EQ(corner_tangents(points, triangles), corner_tangents(mesh.points, mesh.triangles));
}

TEST(TangentSpace, SignedZerosAreEqual) {
    std::vector<SurfacePoint> points = unit_square();
    points.push_back(points[0]);
    points.back().position.z = -0.0f;
    points.back().uv.x = -0.0f;
    EXPECT_EQ(weld(points), (std::vector<std::uint32_t>{0, 1, 2, 3, 0}));
}

TEST(TangentSpace, WhatHasNoDirectionIsFiniteAndUnit) {
    const float huge = 3e38f, nan = std::nanf("");
    struct Case {
        const char* name;
        void (*change)(SurfacePoint& p, float value);
        float value;
    };
    const Case cases[] = {
        {"one texture coordinate", [](SurfacePoint& p, float) { p.uv = vec2(0.5f); }, 0},
        {"a line of coordinates", [](SurfacePoint& p, float) { p.uv.y = p.uv.x; }, 0},
        {"no normals", [](SurfacePoint& p, float) { p.normal = vec3(0); }, 0},
        {"normals along the tangent", [](SurfacePoint& p, float) { p.normal = vec3(1, 0, 0); }, 0},
        {"one place", [](SurfacePoint& p, float) { p.position = vec3(1); }, 0},
        {"a line", [](SurfacePoint& p, float) { p.position.y = 0; }, 0},
        {"huge places", [](SurfacePoint& p, float v) { p.position = p.position * 2.0f * v - v; },
         huge / 2},
        {"huge coordinates", [](SurfacePoint& p, float v) { p.uv = p.uv * 2.0f * v - v; },
         huge / 2},
        {"tiny places", [](SurfacePoint& p, float v) { p.position *= v; }, 1e-42f},
        {"tiny coordinates", [](SurfacePoint& p, float v) { p.uv *= v; }, 1e-42f},
        {"undefined normals", [](SurfacePoint& p, float v) { p.normal = vec3(v); }, nan},
    };
    for (const Case& c : cases) {
        std::vector<SurfacePoint> points = unit_square();
        for (SurfacePoint& p : points)
            c.change(p, c.value);
        for (const vec4& t : corner_tangents(points, kSquare)) {
            EXPECT_NEAR(length(vec3(t)), 1, 1e-6f) << c.name;
            EXPECT_EQ(std::abs(t.w), 1) << c.name;
        }
    }
    EXPECT_TRUE(corner_tangents({}, {}).empty());
}

// A fan of `count` triangles around one vertex; the UVs rotate with it, one full turn.
TexturedMesh fan(std::uint32_t count) {
    TexturedMesh mesh;
    mesh.points.push_back({vec3(0), vec3(0, 0, 1), vec2(0)});
    for (std::uint32_t i = 0; i <= count; ++i) {
        const float a = 6.2831853f * float(i % count) / float(count);
        mesh.points.push_back(
            {vec3(std::cos(a), std::sin(a), 0), vec3(0, 0, 1), vec2(float(i) / float(count), 1)});
        if (i > 0) mesh.triangles.emplace_back(0u, i, i + 1);
    }
    return mesh;
}

TEST(TangentSpace, LargeFansTakeLinearTime) {
    // Testing every pair of 100 thousand at the hub would take minutes. Each rim corner has its
    // side's direction, and the tangent that all share at the hub is still a unit vector.
    const TexturedMesh mesh = fan(100000);
    const std::vector<vec4> tangents = corner_tangents(mesh.points, mesh.triangles);
    for (std::size_t c = 0; c < tangents.size(); ++c)
        ASSERT_NEAR(length(vec3(tangents[c])), 1, 1e-6f) << c;
    EXPECT_NEAR(tangents[1].y, 1, 1e-4f);
}

TEST(TangentSpace, ManyTrianglesOnOneEdgeTakeLinearTime) {
    // All have the same winding except the last, which is adjacent to the first.
    std::vector<SurfacePoint> points = {{vec3(0), vec3(0, 0, 1), vec2(0)},
                                        {vec3(0, 1, 0), vec3(0, 0, 1), vec2(0, 1)}};
    std::vector<uvec3> triangles;
    for (std::uint32_t i = 0; i < 100000; ++i) {
        points.push_back({vec3(1, float(i), 0), vec3(0, 0, 1), vec2(1, float(i))});
        triangles.emplace_back(0u, 1u, i + 2);
    }
    std::swap(triangles.back().x, triangles.back().y);
    const std::vector<std::uint32_t> partners =
        pair_edges(triangles, std::vector<bool>(triangles.size(), false), points.size());
    EXPECT_EQ(partners[0], 3 * (triangles.size() - 1));
    EXPECT_EQ(partners[3 * (triangles.size() - 1)], 0u);
    EXPECT_EQ(partners[3], kNone);
}

}  // namespace
}  // namespace hm
