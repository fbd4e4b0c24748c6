// Buffers, buffer views and accessors: decoding and rejected files.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "gltf/document.h"
#include "gltf/meshes.h"
#include "gltf/source.h"
#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

// A mesh that reads accessor 0 as positions, without indices.
constexpr const char* kPositionsOnly = R"([{"primitives":[{"attributes":{"POSITION":0}}]}])";

const Primitive& only_primitive(const Loaded& loaded) {
    return loaded.scene->meshes.at(0).primitives.at(0);
}

Overrides one_accessor(std::string_view bytes, const std::string& view,
                       const std::string& accessor) {
    return {{"buffers", buffers(bytes)},
            {"bufferViews", "[" + view + "]"},
            {"accessors", "[" + accessor + "]"},
            {"meshes", kPositionsOnly}};
}

TEST(BufferView, BoundsAndStride) {
    const auto view = [](const char* json) { return Overrides{{"bufferViews", json}}; };
    expect_refused({
        {"no buffer", view(R"([{"byteLength":4}])"), "/bufferViews/0/buffer", "is required"},
        {"no such buffer", view(R"([{"buffer":1,"byteLength":4}])"), "/bufferViews/0/buffer",
         "past the end"},
        {"negative", view(R"([{"buffer":-1,"byteLength":4}])"), "/bufferViews/0/buffer",
         "an integer"},
        {"fraction", view(R"([{"buffer":0,"byteLength":4.5}])"), "/bufferViews/0/byteLength",
         "an integer"},
        {"no length", view(R"([{"buffer":0}])"), "/bufferViews/0/byteLength", "is required"},
        {"empty", view(R"([{"buffer":0,"byteLength":0}])"), "/bufferViews/0/byteLength",
         "not be 0"},
        {"past the end", view(R"([{"buffer":0,"byteOffset":160,"byteLength":5}])"),
         "/bufferViews/0", "buffer of 164"},
        {"offset past the end", view(R"([{"buffer":0,"byteOffset":165,"byteLength":1}])"),
         "/bufferViews/0", "buffer of 164"},
        {"overflows 64 bits",
         view(R"([{"buffer":0,"byteOffset":18446744073709551615,"byteLength":2}])"),
         "/bufferViews/0/byteOffset", "2^53"},
        {"largest offset",
         view(R"([{"buffer":0,"byteOffset":9007199254740992,"byteLength":9007199254740992}])"),
         "/bufferViews/0", "buffer of 164"},
        {"stride 2", view(R"([{"buffer":0,"byteLength":36,"byteStride":2}])"),
         "/bufferViews/0/byteStride", "multiple of 4"},
        {"stride 14", view(R"([{"buffer":0,"byteLength":36,"byteStride":14}])"),
         "/bufferViews/0/byteStride", "multiple of 4"},
        {"stride 256", view(R"([{"buffer":0,"byteLength":36,"byteStride":256}])"),
         "/bufferViews/0/byteStride", "multiple of 4"},
    });
}

TEST(Buffer, Refusals) {
    const auto buffer = [](const char* json) { return Overrides{{"buffers", json}}; };
    expect_refused({
        {"no length", buffer(R"([{"uri":"data:;base64,AAAA"}])"), "/buffers/0/byteLength",
         "is required"},
        {"empty", buffer(R"([{"byteLength":0}])"), "/buffers/0/byteLength", "must not be 0"},
        {"data too short", buffer(R"([{"uri":"data:;base64,AAAA","byteLength":4}])"),
         "/buffers/0/byteLength", "only 3 are available"},
        {"bad base64", buffer(R"([{"uri":"data:;base64,AAA","byteLength":3}])"), "/buffers/0/uri",
         "base64"},
        {"uri is a number", buffer(R"([{"uri":1,"byteLength":3}])"), "/buffers/0/uri",
         "expected a string"},
        {"no data", buffer(R"([{"byteLength":164}])"), "/buffers/0", "neither a uri"},
    });
    // More data than byteLength is allowed.
    const std::string longer = buffers(triangle_bytes() + "more");
    EXPECT_TRUE(load_text(document({{"buffers", longer}})).scene);
}

TEST(Accessor, Refusals) {
    const auto accessor = [](const std::string& json) {
        return Overrides{{"accessors", "[" + json + "]"}, {"meshes", kPositionsOnly}};
    };
    const std::string vec3s = R"("componentType":5126,"type":"VEC3")";
    expect_refused({
        {"no component type", accessor(R"({"type":"VEC3","count":3})"),
         "/accessors/0/componentType", "is required"},
        {"32-bit signed", accessor(R"({"componentType":5124,"type":"VEC3","count":3})"),
         "/accessors/0/componentType", "not a component type"},
        {"double", accessor(R"({"componentType":5130,"type":"VEC3","count":3})"),
         "/accessors/0/componentType", "not a component type"},
        {"no type", accessor(R"({"componentType":5126,"count":3})"), "/accessors/0/type",
         "is required"},
        {"VEC5", accessor(R"({"componentType":5126,"type":"VEC5","count":3})"), "/accessors/0/type",
         "\"VEC5\" is not an element type"},
        {"no count", accessor("{" + vec3s + "}"), "/accessors/0/count", "is required"},
        {"count 0", accessor("{" + vec3s + R"(,"count":0})"), "/accessors/0/count", "1 to"},
        {"count 2^32", accessor("{" + vec3s + R"(,"count":4294967296})"), "/accessors/0/count",
         "1 to"},
        {"no such view", accessor("{" + vec3s + R"(,"count":3,"bufferView":6})"),
         "/accessors/0/bufferView", "past the end"},
        {"one too many", accessor("{" + vec3s + R"(,"count":4,"bufferView":0})"), "/accessors/0",
         "ends at byte 48 of buffer view 0, which has 36"},
        {"offset too far", accessor("{" + vec3s + R"(,"count":3,"bufferView":0,"byteOffset":4})"),
         "/accessors/0", "ends at byte 40"},
        {"huge offset",
         accessor("{" + vec3s + R"(,"count":3,"bufferView":0,"byteOffset":9007199254740988})"),
         "/accessors/0", "ends at byte"},
        {"unaligned", accessor("{" + vec3s + R"(,"count":2,"bufferView":0,"byteOffset":2})"),
         "/accessors/0/byteOffset", "aligned to 4"},
        {"normalized is a flag",
         accessor("{" + vec3s + R"(,"count":3,"bufferView":0,"normalized":1})"),
         "/accessors/0/normalized", "expected a boolean"},
        {"huge array of zeros", accessor("{" + vec3s + R"(,"count":4294967290})"),
         "/meshes/0/primitives/0", "bytes of memory"},
        {"narrow stride",
         one_accessor(triangle_bytes(), R"({"buffer":0,"byteLength":36,"byteStride":8})",
                      "{" + vec3s + R"(,"count":3,"bufferView":0})"),
         "/accessors/0/bufferView", "less than the element size, 12"},
    });
}

TEST(Accessor, StrideAndOffset) {
    // x, y, z and a float of padding; the first element starts at byte 4 of the view.
    const std::string bytes = bytes_of(std::vector<float>{9, 9, 1, 2, 3, 9, 4, 5, 6, 9, 7, 8, 10});
    const Loaded loaded = load_text(document(one_accessor(
        bytes, R"({"buffer":0,"byteOffset":4,"byteLength":48,"byteStride":16})",
        R"({"bufferView":0,"byteOffset":4,"componentType":5126,"type":"VEC3","count":3})")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(only_primitive(loaded).vertices[0].position, vec3(1, 2, 3));
    EXPECT_EQ(only_primitive(loaded).vertices[2].position, vec3(7, 8, 10));
    // The last element must be complete, but without the stride's padding.
    expect_refused({{"a byte short",
                     one_accessor(bytes, R"({"buffer":0,"byteLength":47,"byteStride":16})",
                                  R"({"bufferView":0,"byteOffset":4,"componentType":5126,
                                      "type":"VEC3","count":3})"),
                     "/accessors/0", "ends at byte 48"}});
}

TEST(Accessor, NotFinitePositionsAreNamed) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        const std::string bytes = bytes_of(std::vector<float>{0, 0, 0, 1, 0, 0, 0, bad, 0});
        expect_refused({{"not finite",
                         one_accessor(bytes, R"({"buffer":0,"byteLength":36})",
                                      R"({"bufferView":0,"componentType":5126,"type":"VEC3",
                                          "count":3})"),
                         "/accessors/0", "element 2 is"}});
    }
}

TEST(Accessor, LimitsAreThoseOfTheElements) {
    const auto load = [](const char* limits) {
        const std::string bytes =
            bytes_of(std::vector<std::int16_t>{-32768, 0, 1, 0, 32767, 5, 0, 0, 0, 0, 0, 0});
        Overrides all = one_accessor(
            bytes, R"({"buffer":0,"byteLength":24,"byteStride":8})",
            fmt::format(R"({{"bufferView":0,"componentType":5122,"type":"VEC3","count":3,
                "normalized":true{}}})",
                        limits));
        all["extensionsUsed"] = R"(["KHR_mesh_quantization"])";
        return load_text(document(all));
    };
    // min and max of normalized integers are the integers.
    EXPECT_EQ(load(R"(,"min":[-32768,0,0],"max":[32767,5,1])").warned("/accessors/0", "min"), 0u);
    EXPECT_EQ(load(R"(,"min":[-32768,0,0],"max":[32767,6,1])")
                  .warned("/accessors/0", "do not match the elements"),
              1u);
    EXPECT_EQ(load(R"(,"max":[32767,5,1])").warned("/accessors/0", "min and max are missing"), 1u);
}

// Positions 0..3 in view 0, sparse indices (u8) in view 1, values in view 2.
Overrides sparse(const std::vector<std::uint8_t>& indices, const std::string& accessor,
                 std::size_t count) {
    std::string bytes = bytes_of(std::vector<float>{0, 0, 0, 1, 1, 1, 2, 2, 2});
    bytes += bytes_of(std::vector<float>{7, 7, 7, 8, 8, 8}) + bytes_of(indices);
    return {{"buffers", buffers(bytes)},
            {"bufferViews", fmt::format(R"([{{"buffer":0,"byteLength":36}},
                {{"buffer":0,"byteOffset":60,"byteLength":{}}},
                {{"buffer":0,"byteOffset":36,"byteLength":24}}])",
                                        indices.size())},
            {"accessors", fmt::format(R"([{{"componentType":5126,"type":"VEC3","count":3{},
                "sparse":{{"count":{},"indices":{{"bufferView":1,"componentType":5121}},
                "values":{{"bufferView":2}}}}}}])",
                                      accessor, count)},
            {"meshes", kPositionsOnly}};
}

TEST(Accessor, Sparse) {
    const Loaded over = load_text(document(sparse({0, 2}, R"(,"bufferView":0)", 2)));
    ASSERT_TRUE(over.scene) << over.scene.error().line();
    EXPECT_EQ(only_primitive(over).vertices[0].position, vec3(7));
    EXPECT_EQ(only_primitive(over).vertices[1].position, vec3(1));
    EXPECT_EQ(only_primitive(over).vertices[2].position, vec3(8));
    const Loaded alone = load_text(document(sparse({1}, "", 1)));
    ASSERT_TRUE(alone.scene) << alone.scene.error().line();
    EXPECT_EQ(only_primitive(alone).vertices[0].position, vec3(0));
    EXPECT_EQ(only_primitive(alone).vertices[1].position, vec3(7));

    Overrides signed_indices = sparse({0}, "", 1);
    std::string& accessors = signed_indices["accessors"];
    accessors.replace(accessors.find("5121"), 4, "5120");
    Overrides no_values = sparse({0}, "", 1);
    no_values["accessors"] = R"([{"componentType":5126,"type":"VEC3","count":3,"sparse":{"count":1,
        "indices":{"bufferView":1,"componentType":5121}}}])";
    expect_refused({
        {"index past the end", sparse({0, 3}, "", 2), "/accessors/0/sparse/indices",
         "index 3 (element 1) is past"},
        {"not increasing", sparse({1, 1}, "", 2), "/accessors/0/sparse/indices",
         "element 1) is not greater"},
        {"more than elements", sparse({0, 1}, "", 4), "/accessors/0/sparse/count",
         "4 is not between 1 and"},
        {"none", sparse({0}, "", 0), "/accessors/0/sparse/count", "0 is not between 1 and"},
        {"indices cut", sparse({0}, "", 2), "/accessors/0/sparse/indices",
         "2 elements extend past the end of buffer view 1"},
        {"values cut", sparse({0, 1, 2}, "", 3), "/accessors/0/sparse/values",
         "3 elements extend past the end of buffer view 2"},
        {"signed indices", signed_indices, "/accessors/0/sparse/indices/componentType", "unsigned"},
        {"no values", no_values, "/accessors/0/sparse/values", "is required"},
    });
}

// A vertex buffer referenced by many primitives decodes to more than the file's size.
TEST(Accessor, SharedDataIsBounded) {
    const std::string one = R"({"indices":3,"attributes":{"POSITION":0}})";
    const std::string text =
        document({{"meshes", fmt::format(R"([{{"primitives":[{0},{0},{0}]}}])", one)}});
    const std::string file = "scene.gltf";
    const std::uint64_t kept = 3 * sizeof(Vertex) + sizeof(uvec3);
    const auto load = [&](std::uint64_t kept_bytes, std::uint64_t decoded_bytes) {
        Diagnostics diagnostics;
        const JsonDocument document =
            gltf::parse_document(std::as_bytes(std::span(text)), file).value();
        const Json& root = document.root();
        gltf::Source source{file, {}, diagnostics};
        source.budget.kept_bytes = text.size();
        EXPECT_TRUE(gltf::read_buffers(root, source));
        EXPECT_TRUE(gltf::read_buffer_views(root, source));
        EXPECT_TRUE(gltf::read_accessors(root, source));
        source.budget = {kept_bytes, decoded_bytes, kept_bytes};
        const auto meshes = gltf::read_meshes(root, source, {});
        return meshes ? std::string() : meshes.error().location;
    };
    EXPECT_EQ(load(3 * kept, 9 * kept), "");
    EXPECT_EQ(load(3 * kept - 1, 9 * kept), "/meshes/0/primitives/2");
    EXPECT_EQ(load(9 * kept, 3 * kept), "/meshes/0/primitives/2");
    EXPECT_EQ(load(1, 9 * kept), "/meshes/0/primitives/0");
}

}  // namespace
}  // namespace hm::gltf_test
