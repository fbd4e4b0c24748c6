// Whole documents: what is read from a valid file, and errors of the file as a whole.
#include <fmt/format.h>

#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

TEST(Load, ReadsATriangle) {
    const Loaded loaded = load_text(document());
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    const Scene& scene = *loaded.scene;
    EXPECT_TRUE(loaded.diagnostics.warnings().empty());
    ASSERT_EQ(scene.nodes.size(), 1u);
    EXPECT_EQ(scene.nodes[0].mesh, 0);
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].name, "triangle");
    ASSERT_EQ(scene.meshes[0].primitives.size(), 1u);
    const Primitive& primitive = scene.meshes[0].primitives[0];
    EXPECT_EQ(primitive.material, kUnset);
    EXPECT_TRUE(primitive.has_normals);
    EXPECT_FALSE(primitive.has_tangents);
    EXPECT_TRUE(primitive.extras.empty());
    ASSERT_EQ(primitive.triangles.size(), 1u);
    EXPECT_EQ(primitive.triangles[0], uvec3(0, 1, 2));
    ASSERT_EQ(primitive.vertices.size(), 3u);
    EXPECT_EQ(primitive.vertices[2].position, vec3(0, 2, 0));
    EXPECT_EQ(primitive.vertices[1].uv0, vec2(1, 0));
}

TEST(Load, MissingFileIsUnreadable) {
    Diagnostics diagnostics;
    const auto scene = load_gltf("no-such-folder/no-such-file.glb", diagnostics);
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().kind, ErrorKind::unreadable);
}

TEST(Load, TextThatIsNoDocument) {
    const struct {
        const char* what;
        std::string text;
        const char* message;
    } cases[] = {
        {"empty", "", "is empty"},
        {"white space only", "  \n", "is empty"},
        {"not JSON", "hello", "is not valid JSON"},
        {"array", "[]", "is not an object"},
        {"cut", R"({"asset":{"version":"2.0")", "is not valid JSON"},
        {"trailing comma", R"({"asset":{"version":"2.0"},})", "is not valid JSON"},
        {"two documents", document() + document(), "is not valid JSON"},
        {"UTF-16", std::string("\xFF\xFE{\0}\0", 6), "UTF-16"},
        {"bad UTF-8", document({{"extras", "\"\xC3\x28\""}}), "is not valid UTF-8"},
        {"deep array", std::string(100000, '['), "is not valid JSON"},
        {"deep object",
         [] {
             std::string text;
             for (int i = 0; i < 100000; ++i)
                 text += "{\"a\":";
             return text;
         }(),
         "is not valid JSON"},
        {"closed deep array",
         document({{"extras", std::string(100000, '[') + std::string(100000, ']')}}),
         "levels deep"},
    };
    for (const auto& c : cases) {
        const Loaded loaded = load_text(c.text);
        ASSERT_FALSE(loaded.scene) << c.what;
        EXPECT_EQ(loaded.scene.error().kind, ErrorKind::invalid) << c.what;
        EXPECT_NE(loaded.scene.error().message.find(c.message), std::string::npos)
            << c.what << ": " << loaded.scene.error().line();
    }
}

TEST(Load, ModerateNestingInExtrasIsFine) {
    const std::string extras = std::string(200, '[') + std::string(200, ']');
    EXPECT_TRUE(load_text(document({{"extras", extras}})).scene);
}

TEST(Load, VersionsAndExtensions) {
    expect_refused({
        {"no asset", {{"asset", ""}}, "/asset", "is required"},
        {"no version", {{"asset", "{}"}}, "/asset/version", "is required"},
        {"version is a number", {{"asset", R"({"version":2.0})"}}, "/asset/version", "a string"},
        {"no version at all",
         {{"asset", R"({"version":"two"})"}},
         "/asset/version",
         "not a version"},
        {"half a version", {{"asset", R"({"version":"2."})"}}, "/asset/version", "not a version"},
        {"glTF 1",
         {{"asset", R"({"version":"1.0"})"}},
         "/asset/version",
         "only 2.x",
         ErrorKind::unsupported},
        {"too new",
         {{"asset", R"({"version":"2.1","minVersion":"2.1"})"}},
         "/asset/minVersion",
         "requires glTF 2.1",
         ErrorKind::unsupported},
        {"required extensions",
         {{"extensionsRequired", R"(["KHR_a","KHR_materials_unlit","EXT_b"])"}},
         "/extensionsRequired",
         "required but not supported: KHR_a, EXT_b",
         ErrorKind::unsupported},
        {"extension names are strings",
         {{"extensionsRequired", "[1]"}},
         "/extensionsRequired/0",
         "expected a string, found a number"},
        {"extensions are a list",
         {{"extensionsUsed", "{}"}},
         "/extensionsUsed",
         "expected an array, found an object"},
    });
    EXPECT_TRUE(load_text(document({{"asset", R"({"version":"2.7","minVersion":"2.0"})"}})).scene);
    EXPECT_TRUE(load_text(document({{"extensionsRequired",
                                     R"(["KHR_lights_punctual","KHR_materials_emissive_strength",
                                         "KHR_materials_unlit","KHR_texture_transform",
                                         "KHR_materials_variants","KHR_mesh_quantization",
                                         "KHR_node_visibility","EXT_mesh_gpu_instancing"])"}}))
                    .scene);
}

// Metadata extensions are harmless, whether listed, required or unlisted.
TEST(Load, MetadataIsANote) {
    for (const bool required : {false, true}) {
        Overrides overrides = {{"nodes", R"([{"mesh":0,"extensions":{"EXT_mesh_features":{}}}])"}};
        overrides["extensionsUsed"] = R"(["EXT_mesh_features"])";
        if (required) overrides["extensionsRequired"] = R"(["EXT_mesh_features"])";
        const Loaded loaded = load_text(document(overrides));
        ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
        EXPECT_TRUE(loaded.diagnostics.warnings().empty());
        ASSERT_EQ(loaded.diagnostics.notes().size(), 1u);
        EXPECT_NE(loaded.diagnostics.notes()[0].message.find("metadata"), std::string::npos);
    }
}

// The error names a command that converts the file.
TEST(Load, CompressionNamesTheCommandThatUndoesIt) {
    const std::pair<const char*, const char*> cases[] = {
        {R"(["KHR_draco_mesh_compression"])", "gltf-transform copy"},
        {R"(["EXT_meshopt_compression"])", "gltf-transform copy"},
        {R"(["EXT_texture_webp"])", "gltf-transform png"}};
    for (const auto& [required, command] : cases) {
        const Loaded loaded = load_text(document({{"extensionsRequired", required}}));
        ASSERT_FALSE(loaded.scene);
        EXPECT_EQ(loaded.scene.error().kind, ErrorKind::unsupported);
        EXPECT_NE(loaded.scene.error().message.find(command), std::string::npos)
            << loaded.scene.error().line();
    }
}

TEST(Load, WarnsOfUnknownExtensions) {
    const Loaded loaded = load_text(document(
        {{"extensionsUsed", R"(["KHR_a","KHR_materials_unlit","KHR_materials_variants"])"}}));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_TRUE(loaded.diagnostics.warnings().empty());  // no object has it
    ASSERT_EQ(loaded.diagnostics.notes().size(), 1u);
    EXPECT_EQ(loaded.diagnostics.notes()[0].location, "/extensionsUsed/0");

    // The number of uses of each extension, listed or not; those in extras do not count.
    const Loaded counted = load_text(document(
        {{"extensionsUsed", R"(["KHR_a"])"},
         {"nodes", R"([{"mesh":0,"extensions":{"KHR_a":{"extensions":{"KHR_a":{}}},"EXT_b":{}}},
            {"extensions":{"KHR_a":{}},"extras":{"extensions":{"EXT_c":{}}}}])"}}));
    ASSERT_TRUE(counted.scene) << counted.scene.error().line();
    EXPECT_EQ(counted.warned("/extensionsUsed/0", "KHR_a"), 3u);
    EXPECT_EQ(counted.warned("/extensionsUsed", "EXT_b"), 1u);
    EXPECT_EQ(counted.diagnostics.warnings().size(), 2u);
}

TEST(Load, TablesMustBeArraysOfObjects) {
    for (const char* table : {"buffers", "bufferViews", "accessors", "meshes", "nodes", "scenes",
                              "materials", "textures", "images", "samplers", "cameras"}) {
        const std::string pointer = fmt::format("/{}", table);
        expect_refused({
            {table, {{table, "7"}}, pointer.c_str(), "expected an array, found a number"},
            {table,
             {{table, "[null]"}},
             (pointer + "/0").c_str(),
             "expected an object, found null"},
        });
    }
}

}  // namespace
}  // namespace hm::gltf_test
