#include "gltf/uri.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <span>

#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

using namespace gltf;

std::string decoded(std::string_view uri) {
    const auto bytes = decode_data_uri(uri);
    if (!bytes) return "error: " + bytes.error();
    return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

TEST(DataUri, DecodesEveryLengthAndByte) {
    std::string bytes;
    for (int i = 0; i < 300; ++i) {
        EXPECT_EQ(decoded("data:;base64," + base64(bytes)), bytes) << i;
        bytes += static_cast<char>(i * 7);
    }
    EXPECT_EQ(decoded("DATA:image/png;BASE64,TWFu"), "Man");
    EXPECT_EQ(decoded("data:;base64,TWE="), "Ma");
    EXPECT_EQ(decoded("data:;base64,TQ=="), "M");
    EXPECT_EQ(decoded("data:,hello"), "hello");
    EXPECT_EQ(decoded("data:text/plain;charset=utf-8,%00a%fF%2c"), std::string("\0a\xff,", 4));
}

TEST(DataUri, IsStrict) {
    for (const char* uri :
         {"data:;base64", "data:,%", "data:text/plain,%4", "data:,%4g", "data:;base64,TWF",
          "data:;base64,TWF ", "data:;base64,TW=u",
          "data:;base64,TQ=", "data:;base64,T===", "data:;base64,====", "data:;base64,TR==",
          "data:;base64,TWF=", "data:;base64,TW\nE=", "data:;base64,TW-_"})
        EXPECT_FALSE(decode_data_uri(uri)) << uri;
}

TEST(Path, DecodesPercent) {
    EXPECT_EQ(decode_path("a%20b/c%2Bd.png")->string(), "a b/c+d.png");
    EXPECT_EQ(decode_path("%C3%A9.bin")->string(), "\xC3\xA9.bin");
    EXPECT_EQ(decode_path("./a.bin")->string(), "./a.bin");
    EXPECT_EQ(decode_path("a..b.bin")->string(), "a..b.bin");
    EXPECT_EQ(decode_path("dir/a:b.bin")->string(), "dir/a:b.bin");
}

TEST(Path, RefusesWhatLeavesTheFolder) {
    for (const char* uri : {"",
                            "../a.bin",
                            "a/../../b.bin",
                            "a/..",
                            "%2e%2e/a.bin",
                            "/etc/a.bin",
                            "%2Fetc/a.bin",
                            "//host/a.bin",
                            "file:a.bin",
                            "file:///a.bin",
                            "http://host/a.bin",
                            "HTTPS://host/a",
                            "C:/a.bin",
                            "%2e./a.bin",
                            "%2e%2E%2fa.bin",
                            "a%2f%2e%2e%2f%2e%2e%2fb",
                            "..%5ca.bin",
                            "a\\b.bin",
                            "a%5Cb.bin",
                            "data%3a/../a",
                            "ftp://host/a",
                            "a%00b.bin",
                            "a%2.bin",
                            "a%",
                            "a%zz"})
        EXPECT_FALSE(decode_path(uri)) << uri;
}

TEST(Path, ExternalOnesWhereAllowed) {
    EXPECT_EQ(decode_path("../a.bin", true)->string(), "../a.bin");
    EXPECT_EQ(decode_path("%2Fetc/a.bin", true)->string(), "/etc/a.bin");
    EXPECT_EQ(decode_path("file:///etc/a%20b", true)->string(), "/etc/a b");
    EXPECT_EQ(decode_path("FILE:/etc/a", true)->string(), "/etc/a");
    for (const char* uri : {"", "http://host/a", "https:a", "file://host/a", "file:a", "a%00b"})
        EXPECT_FALSE(decode_path(uri, true)) << uri;
}

TEST(Uri, SymbolicLinksThatLeadOut) {
    const Folder outside;
    const std::filesystem::path secret = outside.write("tri.bin", triangle_bytes());
    const Folder folder;
    const std::filesystem::path inside = folder.write("data/tri.bin", triangle_bytes());
    namespace fs = std::filesystem;
    fs::create_symlink(secret, inside.parent_path() / "leak.bin");
    fs::create_directory_symlink(secret.parent_path(), inside.parent_path() / "leak");
    fs::create_symlink(inside, inside.parent_path() / "kept.bin");
    fs::create_symlink(inside.parent_path() / "nothing", inside.parent_path() / "dangling.bin");
    const auto load = [&](const std::string& uri, bool allow_external) {
        const std::string text =
            document({{"buffers", "[{\"uri\":\"" + uri + "\",\"byteLength\":164}]"}});
        Diagnostics diagnostics;
        LoadOptions options;
        options.allow_external = allow_external;
        const auto scene = load_gltf(folder.write("scene.gltf", text), diagnostics, options);
        return scene ? std::nullopt : std::optional(scene.error().kind);
    };
    EXPECT_EQ(load("data/kept.bin", false), std::nullopt);
    EXPECT_EQ(load("data/leak.bin", false), ErrorKind::invalid);
    EXPECT_EQ(load("data/leak/tri.bin", false), ErrorKind::invalid);
    EXPECT_EQ(load("data/dangling.bin", false), ErrorKind::unreadable);
    EXPECT_EQ(load("data/leak.bin", true), std::nullopt);
    EXPECT_EQ(load("data/leak/tri.bin", true), std::nullopt);
    EXPECT_EQ(load(secret.string(), false), ErrorKind::invalid);
    EXPECT_EQ(load(secret.string(), true), std::nullopt);
}

// A file opened by file name alone has an empty folder.
TEST(Uri, MissingFileOfTheWorkingFolder) {
    Diagnostics diagnostics;
    const std::string text =
        document({{"buffers", R"([{"uri":"no such file.bin","byteLength":164}])"}});
    const auto scene =
        load_gltf_bytes(std::as_bytes(std::span(text)), "scene.gltf", diagnostics, {});
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().kind, ErrorKind::unreadable);
    EXPECT_NE(scene.error().message.find("no such file.bin"), std::string::npos);
}

TEST(Uri, ExternalFiles) {
    const Folder folder;
    folder.write("sub dir/tri.bin", triangle_bytes());
    const auto load = [&](const std::string& uri, std::size_t length) {
        const std::string text = document({{"buffers", "[{\"uri\":\"" + uri + "\",\"byteLength\":" +
                                                           std::to_string(length) + "}]"}});
        Diagnostics diagnostics;
        return load_gltf(folder.write("scene.gltf", text), diagnostics);
    };
    EXPECT_TRUE(load("sub%20dir/tri.bin", 164));
    EXPECT_TRUE(load("sub dir/tri.bin", 164));

    const auto shorter = load("sub%20dir/tri.bin", 165);
    ASSERT_FALSE(shorter);
    EXPECT_EQ(shorter.error().kind, ErrorKind::invalid);
    EXPECT_EQ(shorter.error().location, "/buffers/0/byteLength");

    for (const char* missing : {"none.bin", "sub%20dir"}) {
        const auto scene = load(missing, 164);
        ASSERT_FALSE(scene);
        EXPECT_EQ(scene.error().kind, ErrorKind::unreadable);
        EXPECT_EQ(scene.error().location, "/buffers/0/uri");
    }
    const auto escaping = load("../tri.bin", 164);
    ASSERT_FALSE(escaping);
    EXPECT_EQ(escaping.error().kind, ErrorKind::invalid);
    EXPECT_EQ(escaping.error().location, "/buffers/0/uri");
}

}  // namespace
}  // namespace hm::gltf_test
