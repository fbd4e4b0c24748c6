// Extensions of nodes and meshes, and LoadOptions.
#include <fmt/format.h>

#include "gltf/test_files.h"
#include "scene/environment.h"
#include "scene/flatten.h"

namespace hm::gltf_test {
namespace {

Result<Scene> load_with(const std::string& text, const LoadOptions& options) {
    const Folder folder;
    Diagnostics diagnostics;
    return load_gltf(folder.write("scene.gltf", text), diagnostics, options);
}

std::string message_of(const Result<Scene>& scene) {
    return scene ? "no error" : scene.error().line();
}

FlatScene flat_of(const Scene& scene) {
    Diagnostics diagnostics;
    return flatten(scene, {}, {}, diagnostics);
}

// Translations and scales of two instances; rotations as normalized 16-bit integers: the identity
// and pi about y.
Overrides instanced(const std::string& attributes, const std::string& rest = "") {
    const std::string bytes = triangle_bytes() + bytes_of(std::vector<float>{1, 2, 3, 4, 5, 6}) +
                              bytes_of(std::vector<float>{1, 1, 1, 2, 2, 2}) +
                              bytes_of(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 32767, 0, 0});
    return {{"buffers", buffers(bytes)},
            {"bufferViews", R"([{"buffer":0,"byteLength":36},
                {"buffer":0,"byteOffset":164,"byteLength":24},
                {"buffer":0,"byteOffset":188,"byteLength":24},
                {"buffer":0,"byteOffset":212,"byteLength":16}])"},
            {"accessors", R"([{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,
                 "min":[0,0,0],"max":[1,2,0]},
                {"bufferView":1,"componentType":5126,"type":"VEC3","count":2},
                {"bufferView":2,"componentType":5126,"type":"VEC3","count":2},
                {"bufferView":3,"componentType":5122,"type":"VEC4","count":2,"normalized":true}])"},
            {"meshes", R"([{"primitives":[{"attributes":{"POSITION":0}}]}])"},
            {"nodes", fmt::format(R"([{{"mesh":0,"translation":[10,0,0],{}"extensions":
                {{"EXT_mesh_gpu_instancing":{{"attributes":{{{}}}}}}}}}])",
                                  rest, attributes)}};
}

TEST(Instancing, EveryAttribute) {
    const Loaded loaded =
        load_text(document(instanced(R"("TRANSLATION":1,"ROTATION":3,"SCALE":2,"_ID":0)")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_TRUE(loaded.diagnostics.warnings().empty());
    EXPECT_EQ(loaded.scene->meshes.size(), 1u);
    const FlatScene flat = flat_of(*loaded.scene);
    ASSERT_EQ(flat.instances.size(), 2u);
    const vec3 first = flat.instances[0].object_to_world * vec4(1, 0, 0, 1);
    EXPECT_EQ(first, vec3(12, 2, 3));
    // x maps to -2x, translated to (10 + 4, 5, 6).
    const vec3 second = flat.instances[1].object_to_world * vec4(1, 0, 0, 1);
    EXPECT_NEAR(double(second.x), 12, 1e-5);
    EXPECT_NEAR(double(second.y), 5, 1e-5);
    EXPECT_NEAR(double(second.z), 6, 1e-5);
}

TEST(Instancing, ColoursAreAWarning) {
    const Loaded loaded = load_text(document(instanced(R"("TRANSLATION":1,"_COLOR_0":2)")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(loaded.warned("/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/_COLOR_0",
                            "are not read"),
              1u);
}

TEST(Instancing, Refusals) {
    const std::string at = "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes";
    expect_refused({
        {"no attribute", instanced(R"("_ID":0)"), at.c_str(), "has no TRANSLATION"},
        {"counts differ", instanced(R"("TRANSLATION":1,"SCALE":0)"), (at + "/SCALE").c_str(),
         "accessor 0 has 3 elements, another has 2"},
        {"wrong type", instanced(R"("TRANSLATION":3)"), (at + "/TRANSLATION").c_str(),
         "a type that is invalid for"},
        {"no such accessor", instanced(R"("SCALE":4)"), (at + "/SCALE").c_str(), "past the end"},
        {"overflow", instanced(R"("TRANSLATION":1,"SCALE":2)", R"("scale":[3e38,1,1],)"),
         "/nodes/0", "overflows"},
    });
}

TEST(Visibility, HidesWhatIsBelow) {
    const char* hidden = R"("extensions":{"KHR_node_visibility":{"visible":false}})";
    const char* shown = R"("extensions":{"KHR_node_visibility":{"visible":true}})";
    const Loaded loaded = load_text(document(
        {{"nodes", fmt::format(R"([{{"children":[1],{0}}},{{"mesh":0,{1}}},{{"mesh":0,{1}}},
            {{"mesh":0,"extensions":{{"KHR_node_visibility":{{}}}}}}])",
                               hidden, shown)},
         {"scenes", R"([{"nodes":[0,2,3]}])"}}));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(flat_of(*loaded.scene).instances.size(), 2u);
    expect_refused({{"not a flag",
                     {{"nodes", R"([{"extensions":{"KHR_node_visibility":{"visible":1}}}])"}},
                     "/nodes/0/extensions/KHR_node_visibility/visible",
                     "expected a boolean"}});
}

Overrides with_variants(const std::string& mappings) {
    return {{"extensions",
             R"({"KHR_materials_variants":{"variants":[{"name":"red"},{"name":"blue"}]}})"},
            {"materials", "[{},{},{}]"},
            {"meshes", fmt::format(R"([{{"primitives":[{{"material":0,"attributes":{{"POSITION":0}},
            "extensions":{{"KHR_materials_variants":{{"mappings":[{}]}}}}}}]}}])",
                                   mappings)}};
}

TEST(Variants, AreChosenByName) {
    const std::string text =
        document(with_variants(R"({"material":1,"variants":[0]},{"material":2,"variants":[1]})"));
    const auto material = [&](const std::string& name) {
        LoadOptions options;
        options.variant = name;
        const auto scene = load_with(text, options);
        return scene ? scene->meshes.at(0).primitives.at(0).material : -2;
    };
    EXPECT_EQ(material(""), 0);
    EXPECT_EQ(material("red"), 1);
    EXPECT_EQ(material("blue"), 2);
    LoadOptions options;
    options.variant = "green";
    const auto unknown = load_with(text, options);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().kind, ErrorKind::invalid_argument);
    EXPECT_NE(unknown.error().message.find(R"("red", "blue")"), std::string::npos);
    EXPECT_EQ(load_with(document(), options).error().kind, ErrorKind::invalid_argument);

    const char* at = "/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/0";
    expect_refused({
        {"no such variant", with_variants(R"({"material":1,"variants":[2]})"),
         (std::string(at) + "/variants/0").c_str(), "past the end"},
        {"no such material", with_variants(R"({"material":3,"variants":[0]})"),
         (std::string(at) + "/material").c_str(), "past the end"},
    });
}

TEST(Scenes, AreChosenByNameOrIndex) {
    const std::string text = document(
        {{"nodes", R"([{"name":"a"},{"name":"b"},{"name":"c"}])"},
         {"scenes", R"([{"nodes":[0],"name":"2"},{"nodes":[1]},{"nodes":[2],"name":"last"}])"}});
    const auto shown = [&](const std::string& wanted) {
        LoadOptions options;
        options.scene = wanted;
        const auto scene = load_with(text, options);
        return scene ? scene->nodes.at(0).name : std::to_string(int(scene.error().kind));
    };
    EXPECT_EQ(shown(""), "a");
    EXPECT_EQ(shown("1"), "b");
    EXPECT_EQ(shown("last"), "c");
    EXPECT_EQ(shown("2"), "a");  // names take precedence over indices
    EXPECT_EQ(shown("3"), std::to_string(int(ErrorKind::invalid_argument)));
    EXPECT_EQ(shown("-1"), std::to_string(int(ErrorKind::invalid_argument)));
}

// Positions as 16-bit integers with stride 8, normals as normalized bytes, texture coordinates as
// unnormalized bytes.
Overrides quantized(const std::string& extensions, const std::string& normalized = "") {
    const std::string bytes =
        bytes_of(std::vector<std::int16_t>{-32768, 1, 2, 0, 32767, 4, 5, 0, 7, 8, 9, 0}) +
        bytes_of(std::vector<std::int8_t>{0, 0, 127, 0, 0, -127, 0, 0, -128, 0, 0, 0}) +
        bytes_of(std::vector<std::uint8_t>{1, 2, 0, 0, 3, 4, 0, 0, 255, 0, 0, 0});
    return {{"extensionsUsed", extensions},
            {"buffers", buffers(bytes)},
            {"bufferViews", R"([{"buffer":0,"byteLength":24,"byteStride":8},
                {"buffer":0,"byteOffset":24,"byteLength":12,"byteStride":4},
                {"buffer":0,"byteOffset":36,"byteLength":12,"byteStride":4}])"},
            {"accessors", fmt::format(R"([
                {{"bufferView":0,"componentType":5122,"type":"VEC3","count":3{}}},
                {{"bufferView":1,"componentType":5120,"type":"VEC3","count":3,"normalized":true}},
                {{"bufferView":2,"componentType":5121,"type":"VEC2","count":3}}])",
                                      normalized)},
            {"meshes", R"([{"primitives":[{"attributes":
                {"POSITION":0,"NORMAL":1,"TEXCOORD_0":2}}]}])"}};
}

TEST(Quantization, IntegersOfEveryKind) {
    const std::string used = R"(["KHR_mesh_quantization"])";
    const Loaded plain = load_text(document(quantized(used)));
    ASSERT_TRUE(plain.scene) << plain.scene.error().line();
    const std::vector<Vertex>& v = plain.scene->meshes.at(0).primitives.at(0).vertices;
    EXPECT_EQ(v[0].position, vec3(-32768, 1, 2));
    EXPECT_EQ(v[1].normal, vec3(0, -1, 0));
    EXPECT_EQ(v[2].normal, vec3(-1, 0, 0));
    EXPECT_EQ(v[2].uv0, vec2(255, 0));
    const Loaded scaled = load_text(document(quantized(used, R"(,"normalized":true)")));
    ASSERT_TRUE(scaled.scene) << scaled.scene.error().line();
    EXPECT_EQ(scaled.scene->meshes.at(0).primitives.at(0).vertices[0].position.x, -1.0f);
    EXPECT_EQ(scaled.scene->meshes.at(0).primitives.at(0).vertices[1].position.x, 1.0f);
    expect_refused({{"without the extension", quantized(""),
                     "/meshes/0/primitives/0/attributes/POSITION", "a type that is invalid for"}});
}

TEST(Quantization, IntegersOfMorphTargets) {
    const auto load = [](const std::string& used, const std::string& normalized) {
        Overrides all = quantized(used);
        const std::string bytes =
            bytes_of(std::vector<std::int16_t>{-32768, 1, 2, 0, 32767, 4, 5, 0, 7, 8, 9, 0}) +
            bytes_of(std::vector<std::int8_t>{0, 0, 127, 0, 0, -127, 0, 0, -128, 0, 0, 0});
        all["buffers"] = buffers(bytes);
        all["bufferViews"] = R"([{"buffer":0,"byteLength":24,"byteStride":8},
            {"buffer":0,"byteOffset":24,"byteLength":12,"byteStride":4}])";
        all["accessors"] = fmt::format(
            R"([{{"bufferView":0,"componentType":5122,"type":"VEC3","count":3}},
            {{"bufferView":1,"componentType":5120,"type":"VEC3","count":3,"normalized":true}},
            {{"bufferView":0,"componentType":5122,"type":"VEC3","count":3{}}}])",
            normalized);
        all["meshes"] = R"([{"weights":[1],"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},
            "targets":[{"POSITION":2,"NORMAL":1}]}]}])";
        return load_text(document(all));
    };
    const std::string used = R"(["KHR_mesh_quantization"])";
    const Loaded plain = load(used, "");
    ASSERT_TRUE(plain.scene) << plain.scene.error().line();
    const std::vector<Vertex>& v = plain.scene->meshes.at(0).primitives.at(0).vertices;
    EXPECT_EQ(v[1].position, vec3(65534, 8, 10));  // twice the integer, not normalized
    EXPECT_EQ(v[1].normal, vec3(0, -1, 0));
    const Loaded scaled = load(used, R"(,"normalized":true)");
    ASSERT_TRUE(scaled.scene) << scaled.scene.error().line();
    EXPECT_EQ(scaled.scene->meshes.at(0).primitives.at(0).vertices[1].position.x, 32768.0f);
    EXPECT_FALSE(load("[]", "").scene);
}

TEST(Json, RepeatedKeysAreRefused) {
    expect_refused({
        {"at the top", {{"x", "1,\"x\":2"}}, "/x", "is repeated"},
        {"below",
         {{"extras", R"([0,{"a/b~":{"k":1,"l":2,"k":3}}])"}},
         "/extras/1/a~1b~0/k",
         "is repeated"},
        {"a number too large", {{"extras", "1e400"}}, "", "beyond a 64-bit float"},
        {"beyond a float",
         {{"nodes", R"([{"translation":[0,1e39,0]}])"}},
         "/nodes/0/translation/1",
         "does not fit a 32-bit float"},
    });
    EXPECT_TRUE(load_text(document({{"nodes", R"([{"translation":[0,1e-320,1e-42]}])"}})).scene);
}

TEST(MemoryLimit, IsKeptBeforeMemoryIsTaken) {
    const auto load = [](const Overrides& overrides, std::uint64_t limit) {
        LoadOptions options;
        options.memory_limit = limit;
        return message_of(load_with(document(overrides), options));
    };
    constexpr std::uint64_t kMegabyte = 1 << 20;
    EXPECT_EQ(load({}, kMegabyte), "no error");
    EXPECT_NE(load({}, 100).find("of memory, but only 100 are left of the limit of 100"),
              std::string::npos);
    const std::string zeros =
        load({{"accessors", R"([{"componentType":5126,"type":"VEC3","count":1000000}])"},
              {"meshes", R"([{"primitives":[{"attributes":{"POSITION":0}}]}])"}},
             kMegabyte);
    EXPECT_NE(zeros.find("/meshes/0/primitives/0: needs"), std::string::npos) << zeros;
    // A header for 16384 x 16384 pixels without any pixel data.
    std::string png("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\x40\0\0\0\x40\0\x08\x06\0\0\0", 29);
    const Overrides image = {
        {"images", fmt::format(R"([{{"uri":"data:image/png;base64,{}"}}])", base64(png))},
        {"textures", R"([{"source":0}])"},
        {"materials", R"([{"emissiveTexture":{"index":0}}])"},
        {"meshes", R"([{"primitives":[{"material":0,"attributes":
            {"POSITION":0,"TEXCOORD_0":2}}]}])"}};
    const std::string pixels = load(image, kMegabyte);
    EXPECT_NE(pixels.find("/images/0: needs 1073741824 bytes"), std::string::npos) << pixels;
    // Enough memory for the pixels, but not for decoding them.
    const std::string rows = load(image, 1536 * kMegabyte);
    EXPECT_NE(rows.find("/images: needs 1073741824 bytes"), std::string::npos) << rows;
}

}  // namespace
}  // namespace hm::gltf_test
