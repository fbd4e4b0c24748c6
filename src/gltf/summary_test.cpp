// File summaries, also of files that cannot be loaded.
#include "gltf/summary.h"

#include <optional>

#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

TEST(Summary, TellsOfAFileThatIsRefused) {
    const Folder folder;
    const auto path = folder.write(
        "file.gltf",
        document({
            {"asset", R"({"version":"2.0","generator":"by hand","copyright":"nobody"})"},
            {"extensionsUsed", R"(["EXT_a","KHR_materials_unlit","EXT_a"])"},
            {"extensionsRequired", R"(["KHR_materials_unlit","EXT_b"])"},
            {"extensions", R"({"KHR_lights_punctual":{"lights":[{},{}]},
                "KHR_materials_variants":{"variants":[{"name":"red"},{"name":"blue"}]}})"},
            {"scenes", R"([{"name":"first"},{"nodes":[0]}])"},
            {"scene", "1"},
        }));
    const auto summary = read_summary(path);
    ASSERT_TRUE(summary) << summary.error().line();
    EXPECT_FALSE(summary->binary);
    EXPECT_EQ(summary->version, "2.0");
    EXPECT_EQ(summary->generator, "by hand");
    EXPECT_EQ(summary->copyright, "nobody");
    ASSERT_EQ(summary->extensions.size(), 3u);
    EXPECT_EQ(summary->extensions[0].name, "EXT_a");
    EXPECT_FALSE(summary->extensions[0].required);
    EXPECT_FALSE(summary->extensions[0].supported);
    EXPECT_EQ(summary->extensions[1].name, "KHR_materials_unlit");
    EXPECT_TRUE(summary->extensions[1].required);
    EXPECT_TRUE(summary->extensions[1].supported);
    EXPECT_EQ(summary->extensions[2].name, "EXT_b");
    EXPECT_TRUE(summary->extensions[2].required);
    EXPECT_FALSE(summary->extensions[2].supported);
    EXPECT_EQ(summary->counts.lights, 2u);
    EXPECT_EQ(summary->counts.accessors, 6u);
    EXPECT_EQ(summary->counts.buffer_views, 6u);
    EXPECT_EQ(summary->counts.animations, 0u);
    EXPECT_EQ(summary->scenes, (std::vector<std::string>{"first", ""}));
    EXPECT_EQ(summary->scene, 1u);
    EXPECT_EQ(summary->variants, (std::vector<std::string>{"red", "blue"}));
}

TEST(Summary, TellsGlbFromText) {
    const Folder folder;
    const std::string bytes = glb(R"({"asset":{"version":"2.0"}})", "");
    const auto summary = read_summary(folder.write("file.glb", bytes));
    ASSERT_TRUE(summary) << summary.error().line();
    EXPECT_TRUE(summary->binary);
    EXPECT_EQ(summary->bytes, bytes.size());
    EXPECT_EQ(summary->counts.nodes, 0u);
}

TEST(Summary, WhatIsNoGltfIsRefused) {
    const Folder folder;
    const auto code_of = [&](std::string_view content) {
        const auto summary = read_summary(folder.write("file.gltf", content));
        return summary ? std::nullopt : std::optional(summary.error().kind);
    };
    EXPECT_EQ(code_of("hello"), ErrorKind::invalid);
    EXPECT_EQ(code_of(R"({"nodes":7})"), ErrorKind::invalid);
    EXPECT_EQ(code_of(R"({"extensionsUsed":[7]})"), ErrorKind::invalid);
    EXPECT_EQ(code_of(R"({"scenes":[{}],"scene":1})"), ErrorKind::invalid);
    const auto missing = read_summary("no-such-folder/no-such-file.glb");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::unreadable);
}

}  // namespace
}  // namespace hm::gltf_test
