// Primitives: attributes, indices and topologies.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "gltf/test_files.h"
#include "gltf/triangles.h"

namespace hm::gltf_test {
namespace {

Overrides primitive(const std::string& json) {
    return {{"meshes", "[{\"primitives\":[" + json + "]}]"}};
}

const Primitive& first(const Loaded& loaded) {
    return loaded.scene->meshes.at(0).primitives.at(0);
}

// The same with a material whose texture reads TEXCOORD_1.
Overrides reading_uv1(const std::string& attributes) {
    Overrides out = primitive(fmt::format(R"({{"material":0,"attributes":{}}})", attributes));
    out["materials"] = R"([{"emissiveTexture":{"index":0,"texCoord":1}}])";
    out["textures"] = R"([{"source":0}])";
    out["images"] = fmt::format(R"([{{"uri":"data:image/png;base64,{}"}}])", kPng1);
    return out;
}

// The base document with a part of its buffer replaced.
Overrides with_bytes(std::size_t at, const std::string& bytes, const std::string& json) {
    Overrides out = primitive(json);
    out["buffers"] = buffers(triangle_bytes().replace(at, bytes.size(), bytes));
    return out;
}

TEST(Meshes, EveryAttribute) {
    const Loaded loaded =
        load_text(document(reading_uv1(R"({"POSITION":0,"NORMAL":1,"TANGENT":5,"TEXCOORD_0":2,
                      "TEXCOORD_1":2,"COLOR_0":4,"_CUSTOM":3})")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    const Primitive& p = first(loaded);
    EXPECT_TRUE(p.has_normals && p.has_tangents);
    ASSERT_EQ(p.vertices.size(), 3u);
    ASSERT_EQ(p.extras.size(), 3u);
    EXPECT_EQ(p.vertices[1].normal, vec3(0, 0, 1));  // normalized
    EXPECT_NEAR(double(p.vertices[2].normal.y), 0.6, 1e-7);
    EXPECT_EQ(p.vertices[1].tangent, vec4(1, 0, 0, -1));
    EXPECT_EQ(p.extras[2].uv1, vec2(0, 1));
    EXPECT_EQ(p.extras[0].color, vec4(1, 0, 51.0f / 255.0f, 1));
    EXPECT_EQ(p.extras[1].color.w, 102.0f / 255.0f);
    EXPECT_TRUE(loaded.diagnostics.warnings().empty());
}

TEST(Meshes, ExtrasOnlyWhereGivenAndRead) {
    const Loaded colors =
        load_text(document(primitive(R"({"attributes":{"POSITION":0,"COLOR_0":0}})")));
    ASSERT_TRUE(colors.scene) << colors.scene.error().line();
    EXPECT_EQ(first(colors).extras[1].color, vec4(1, 0, 0, 1));  // VEC3: alpha 1
    EXPECT_EQ(first(colors).extras[1].uv1, vec2(0));
    EXPECT_EQ(first(colors).extras[2].color, vec4(0, 1, 0, 1));  // 2, clamped
    EXPECT_EQ(colors.warned("/accessors/0", "vertex colours outside"), 1u);
    EXPECT_FALSE(first(colors).has_normals);
    EXPECT_EQ(first(colors).vertices[0].normal, vec3(0));

    const Loaded uv1 = load_text(document(reading_uv1(R"({"POSITION":0,"TEXCOORD_1":2})")));
    ASSERT_TRUE(uv1.scene) << uv1.scene.error().line();
    ASSERT_EQ(first(uv1).extras.size(), 3u);
    EXPECT_EQ(first(uv1).extras[1].color, vec4(1));
    EXPECT_EQ(first(uv1).extras[1].uv1, vec2(1, 0));

    const std::string unread = R"({"attributes":{"POSITION":0,"TEXCOORD_1":2}})";
    const Loaded without = load_text(document(primitive(unread)));
    ASSERT_TRUE(without.scene) << without.scene.error().line();
    EXPECT_TRUE(first(without).extras.empty());
    const std::string nan = bytes_of(std::vector<float>{std::numeric_limits<float>::quiet_NaN()});
    const Loaded ignored = load_text(document(with_bytes(72, nan, unread)));
    ASSERT_TRUE(ignored.scene) << ignored.scene.error().line();
    EXPECT_TRUE(ignored.diagnostics.warnings().empty());
}

TEST(Meshes, NanCoordinatesBecomeZero) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const Loaded loaded =
        load_text(document(with_bytes(72, bytes_of(std::vector<float>{nan, 0.5f, 0.25f, infinity}),
                                      R"({"attributes":{"POSITION":0,"TEXCOORD_0":2}})")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(first(loaded).vertices[0].uv0, vec2(0, 0.5f));
    EXPECT_EQ(first(loaded).vertices[1].uv0, vec2(0.25f, 0));
    EXPECT_EQ(loaded.warned("/accessors/2", "NaN or infinite"), 2u);
}

TEST(Meshes, NormalizedTextureCoordinates) {
    const std::vector<std::uint16_t> uv16{0, 65535, 13107, 0, 65535, 0};
    Overrides overrides =
        with_bytes(72, bytes_of(uv16), R"({"attributes":{"POSITION":0,"TEXCOORD_0":6}})");
    std::string accessors = document();
    overrides["accessors"] = R"([
        {"bufferView":0,"componentType":5126,"type":"VEC3","count":3},{"componentType":5126,
        "type":"VEC3","count":3},{"componentType":5126,"type":"VEC3","count":3},{"componentType":
        5126,"type":"VEC3","count":3},{"componentType":5126,"type":"VEC3","count":3},
        {"componentType":5126,"type":"VEC3","count":3},
        {"bufferView":2,"componentType":5123,"type":"VEC2","count":3,"normalized":true}])";
    const Loaded loaded = load_text(document(overrides));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(first(loaded).vertices[0].uv0, vec2(0, 1));
    EXPECT_EQ(first(loaded).vertices[1].uv0, vec2(0.2f, 0));
}

TEST(Meshes, Topologies) {
    using gltf::make_triangles;
    using gltf::Topology;
    const auto from_4 = [](std::size_t count) {
        gltf::Indices indices(count);
        std::iota(indices.each().begin(), indices.each().end(), 4u);
        return indices;
    };
    EXPECT_EQ(make_triangles(Topology::triangles, from_4(5)), (std::vector<uvec3>{{4, 5, 6}}));
    EXPECT_EQ(make_triangles(Topology::triangles, from_4(6)),
              (std::vector<uvec3>{{4, 5, 6}, {7, 8, 9}}));
    EXPECT_EQ(make_triangles(Topology::strip, from_4(5)),
              (std::vector<uvec3>{{4, 5, 6}, {5, 7, 6}, {6, 7, 8}}));
    EXPECT_EQ(make_triangles(Topology::fan, from_4(5)),
              (std::vector<uvec3>{{5, 6, 4}, {6, 7, 4}, {7, 8, 4}}));
    for (const Topology topology : {Topology::triangles, Topology::strip, Topology::fan}) {
        EXPECT_TRUE(make_triangles(topology, from_4(0)).empty());
        EXPECT_TRUE(make_triangles(topology, from_4(2)).empty());
    }
    for (const int mode : {4, 5, 6}) {
        const Loaded loaded = load_text(document(
            primitive(fmt::format(R"({{"mode":{},"attributes":{{"POSITION":0}}}})", mode))));
        ASSERT_TRUE(loaded.scene);
        ASSERT_EQ(first(loaded).triangles.size(), 1u);
        EXPECT_EQ(first(loaded).triangles[0], mode == 6 ? uvec3(1, 2, 0) : uvec3(0, 1, 2));
    }
}

TEST(Meshes, LeavesOutWhatMakesNoTriangles) {
    for (const char* mode : {"0", "1", "2", "3"}) {
        const Loaded loaded = load_text(document(
            primitive(fmt::format(R"({{"mode":{},"attributes":{{"POSITION":0}}}})", mode))));
        ASSERT_TRUE(loaded.scene);
        EXPECT_TRUE(loaded.scene->meshes.at(0).primitives.empty());
        EXPECT_EQ(loaded.warned("/meshes/0/primitives/0", "points and lines"), 1u);
    }
    const Loaded nothing = load_text(document(primitive(R"({"attributes":{"NORMAL":1}})")));
    ASSERT_TRUE(nothing.scene);
    EXPECT_EQ(nothing.warned("/meshes/0/primitives/0", "without POSITION"), 1u);

    const Loaded empty = load_text(document({{"meshes", R"([{"primitives":[]}])"}}));
    ASSERT_TRUE(empty.scene);
    EXPECT_EQ(empty.warned("/meshes/0", "has no primitives"), 1u);
}

TEST(Meshes, LeftOverIndices) {
    Overrides overrides = primitive(R"({"indices":3,"attributes":{"POSITION":0}})");
    // The view has three indices; count 2 is less than a triangle.
    std::string text = document(overrides);
    const std::string from = R"("type":"SCALAR","count":3)";
    text.replace(text.find(from), from.size(), R"("type":"SCALAR","count":2)");
    const Loaded loaded = load_text(text);
    ASSERT_TRUE(loaded.scene);
    EXPECT_TRUE(loaded.scene->meshes.at(0).primitives.empty());
    EXPECT_EQ(loaded.warned("/meshes/0/primitives/0", "do not complete a triangle"), 1u);
}

TEST(Meshes, Refusals) {
    const std::string good = R"("attributes":{"POSITION":0})";
    const auto index = [&](std::vector<std::uint16_t> values) {
        return with_bytes(96, bytes_of(values), R"({"indices":3,"attributes":{"POSITION":0}})");
    };
    expect_refused({
        {"no attributes", primitive("{}"), "/meshes/0/primitives/0/attributes", "is required"},
        {"no such accessor", primitive(R"({"attributes":{"POSITION":6}})"),
         "/meshes/0/primitives/0/attributes/POSITION", "past the end"},
        {"positions of two", primitive(R"({"attributes":{"POSITION":2}})"),
         "/meshes/0/primitives/0/attributes/POSITION", "a type that is invalid for"},
        {"normals of bytes", primitive(R"({"attributes":{"POSITION":0,"NORMAL":4}})"),
         "/meshes/0/primitives/0/attributes/NORMAL", "a type that is invalid for"},
        {"tangents of three", primitive(R"({"attributes":{"POSITION":0,"TANGENT":1}})"),
         "/meshes/0/primitives/0/attributes/TANGENT", "a type that is invalid for"},
        {"uv of three", primitive(R"({"attributes":{"POSITION":0,"TEXCOORD_1":1}})"),
         "/meshes/0/primitives/0/attributes/TEXCOORD_1", "a type that is invalid for"},
        {"colours of shorts", primitive(R"({"attributes":{"POSITION":0,"COLOR_0":3}})"),
         "/meshes/0/primitives/0/attributes/COLOR_0", "a type that is invalid for"},
        {"mode 7", primitive("{\"mode\":7," + good + "}"), "/meshes/0/primitives/0/mode",
         "not a mode"},
        {"no such material", primitive("{\"material\":0," + good + "}"),
         "/meshes/0/primitives/0/material", "past the end of the 0"},
        {"no such indices", primitive("{\"indices\":9," + good + "}"),
         "/meshes/0/primitives/0/indices", "past the end"},
        {"float indices", primitive("{\"indices\":0," + good + "}"),
         "/meshes/0/primitives/0/indices", "unsigned integer scalars"},
        {"index 3 of 3", index({0, 1, 3}), "/meshes/0/primitives/0/indices",
         "index 3 (element 2 of accessor 3) is past the end of the 3 vertices"},
        {"restart", index({0, 65535, 2}), "/meshes/0/primitives/0/indices", "index 65535"},
    });
}

TEST(Meshes, AttributeCountsMustAgree) {
    std::string text = document();
    // Accessor 1, the normals.
    const std::string from = R"({"bufferView":1,"componentType":5126,"type":"VEC3","count":3})";
    text.replace(text.find(from), from.size(),
                 R"({"bufferView":1,"componentType":5126,"type":"VEC3","count":2})");
    const Loaded loaded = load_text(text);
    ASSERT_FALSE(loaded.scene);
    EXPECT_EQ(loaded.scene.error().location, "/meshes/0/primitives/0/attributes/NORMAL");
    EXPECT_NE(loaded.scene.error().message.find("2 elements, POSITION has 3"), std::string::npos);
}

TEST(Meshes, BrokenNormalsAndTangents) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Loaded normals = load_text(
        document(with_bytes(36, bytes_of(std::vector<float>{0, 0, 0, nan, 0, 1, 3e38f, 0, 3e38f}),
                            R"({"attributes":{"POSITION":0,"NORMAL":1}})")));
    ASSERT_TRUE(normals.scene) << normals.scene.error().line();
    EXPECT_EQ(first(normals).vertices[0].normal, vec3(0));
    EXPECT_EQ(first(normals).vertices[1].normal, vec3(0));
    EXPECT_NEAR(double(first(normals).vertices[2].normal.x), std::sqrt(0.5), 1e-6);
    EXPECT_EQ(normals.warned("/accessors/1", "some normals"), 1u);

    const Loaded tangents = load_text(document(
        with_bytes(116, bytes_of(std::vector<float>{0, 0, 0, 1, 1, 0, 0, 0, nan, 0, 0, -1}),
                   R"({"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":5}})")));
    ASSERT_TRUE(tangents.scene) << tangents.scene.error().line();
    for (const Vertex& vertex : first(tangents).vertices) {
        const vec3 direction(vertex.tangent.x, vertex.tangent.y, vertex.tangent.z);
        EXPECT_NEAR(double(length(direction)), 1, 1e-6);
        EXPECT_EQ(std::abs(vertex.tangent.w), 1.0f);
    }
    EXPECT_EQ(tangents.warned("/accessors/5", "some tangents"), 1u);

    const Loaded alone =
        load_text(document(primitive(R"({"attributes":{"POSITION":0,"TANGENT":5}})")));
    ASSERT_TRUE(alone.scene);
    EXPECT_FALSE(first(alone).has_tangents);
}

TEST(Meshes, UnusedVerticesAreDropped) {
    Primitive p;
    p.vertices.resize(10);
    p.extras.resize(10);
    for (std::size_t i = 0; i < 10; ++i) {
        p.vertices[i].position = vec3(float(i));
        p.extras[i].uv1 = vec2(float(i));
    }
    p.triangles = {{7, 2, 9}, {9, 2, 7}};
    gltf::drop_unused_vertices(p);
    EXPECT_EQ(p.triangles, (std::vector<uvec3>{{0, 1, 2}, {2, 1, 0}}));
    ASSERT_EQ(p.vertices.size(), 3u);
    ASSERT_EQ(p.extras.size(), 3u);
    EXPECT_EQ(p.vertices[0].position, vec3(7));
    EXPECT_EQ(p.extras[2].uv1, vec2(9));
}

}  // namespace
}  // namespace hm::gltf_test
