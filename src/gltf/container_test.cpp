// GLB: chunk layout, and files truncated anywhere.
#include <random>

#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

std::string chunk_document() {
    return document({{"buffers", R"([{"byteLength":164}])"}});
}

std::string word(std::uint32_t value) {
    return bytes_of(std::vector<std::uint32_t>{value});
}

std::string with_word(std::string file, std::size_t at, std::uint32_t value) {
    return file.replace(at, 4, word(value));
}

// Appends `tail` and updates the length in the header.
std::string extended(std::string file, const std::string& tail) {
    file += tail;
    return with_word(file, 8, static_cast<std::uint32_t>(file.size()));
}

TEST(Container, ReadsGlbWhateverItsName) {
    const Loaded loaded = load_text(glb(chunk_document(), triangle_bytes()));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(loaded.scene->meshes[0].primitives[0].vertices[2].position, vec3(0, 2, 0));
    EXPECT_TRUE(loaded.diagnostics.warnings().empty());
    EXPECT_TRUE(load_text(glb(document(), "")).scene);
}

TEST(Container, ByteOrderMark) {
    const std::string marked = "\xEF\xBB\xBF" + document();
    for (const std::string& bytes : {marked, glb(marked, "")}) {
        const Loaded loaded = load_text(bytes);
        EXPECT_TRUE(loaded.scene) << loaded.scene.error().line();
        EXPECT_TRUE(loaded.diagnostics.warnings().empty());
    }
}

TEST(Container, ToleratesWithAWarning) {
    const std::string file = glb(chunk_document(), triangle_bytes());
    const std::string pointer = "byte " + std::to_string(file.size());
    const Loaded trailing = load_text(file + "junk");
    ASSERT_TRUE(trailing.scene);
    EXPECT_EQ(trailing.warned(pointer, "after the end of the GLB"), 1u);

    const Loaded unknown = load_text(extended(file, word(4) + "ABCD" + "1234"));
    ASSERT_TRUE(unknown.scene);
    EXPECT_EQ(unknown.warned(pointer, "unknown type"), 1u);

    // BIN must be the second chunk if present.
    const Loaded second = load_text(extended(file, word(4) + std::string("BIN\0", 4) + "1234"));
    ASSERT_TRUE(second.scene);
    EXPECT_EQ(second.warned(pointer, "unknown type"), 1u);
}

TEST(Container, RefusesBrokenLayouts) {
    const std::string good = glb(chunk_document(), triangle_bytes());
    const auto size = static_cast<std::uint32_t>(good.size());
    const std::string end = "byte " + std::to_string(size);
    const struct {
        const char* what;
        std::string file;
        const char* pointer;
        const char* message;
        ErrorKind kind = ErrorKind::invalid;
    } cases[] = {
        {"version 1", with_word(good, 4, 1), "byte 4", "only 2", ErrorKind::unsupported},
        {"longer than the file", with_word(good, 8, size + 4), "byte 8", "the file has"},
        {"shorter than its header", with_word(good, 8, 8), "byte 8", "a length of 8 bytes"},
        {"chunk past the end", with_word(good, 12, size), "byte 12", "extends past the end"},
        {"huge chunk", with_word(good, 12, 0xffffffffu), "byte 12", "extends past the end"},
        {"odd chunk", with_word(good, 12, 5), "byte 12", "not a multiple of 4"},
        {"BIN first", with_word(good, 16, 0x004e4942), "byte 12", "not JSON"},
        {"no chunk", extended(good.substr(0, 12), ""), "byte 12", "no JSON"},
        {"empty JSON", extended(good.substr(0, 12), word(0) + "JSON"), "byte 20", "no JSON"},
        {"half a chunk header", extended(good, word(0)), end.c_str(), "header is truncated"},
        {"magic only", "glTF", "byte 4", "header is truncated"},
        {"BIN too short", glb(chunk_document(), triangle_bytes().substr(0, 160)),
         "/buffers/0/byteLength", "only 160 are available"},
        {"BIN missing", glb(chunk_document(), ""), "/buffers/0", "neither a uri nor a GLB chunk"},
    };
    for (const auto& c : cases) {
        const Loaded loaded = load_text(c.file);
        ASSERT_FALSE(loaded.scene) << c.what;
        const Error& error = loaded.scene.error();
        EXPECT_EQ(error.kind, c.kind) << c.what << ": " << error.line();
        EXPECT_EQ(error.location, c.pointer) << c.what << ": " << error.line();
        EXPECT_NE(error.message.find(c.message), std::string::npos)
            << c.what << ": " << error.line();
    }
}

TEST(Container, CutAnywhereIsAnError) {
    const std::string good = glb(chunk_document(), triangle_bytes());
    const Folder folder;
    for (std::size_t size = 0; size < good.size(); ++size) {
        Diagnostics diagnostics;
        const std::string cut = good.substr(0, size);
        EXPECT_FALSE(load_gltf(folder.write("cut.glb", cut), diagnostics)) << size;
        // Also if the header has the truncated size.
        if (size < 12) continue;
        const auto path = folder.write("cut.glb", with_word(cut, 8, std::uint32_t(size)));
        EXPECT_FALSE(load_gltf(path, diagnostics)) << size;
    }
}

// A file with any byte changed loads or is rejected; sanitizers check the rest.
TEST(Container, ChangedBytesNeverCrash) {
    const std::string good = glb(chunk_document(), triangle_bytes());
    const std::string likely = "0123456789-.eE[]{},:\" ";
    const Folder folder;
    std::mt19937 random(7);
    std::size_t refused = 0;
    for (int run = 0; run < 1000; ++run) {
        std::string changed = good;
        for (unsigned n = 1 + random() % 4; n > 0; --n) {
            const std::size_t at = random() % changed.size();
            const bool in_json = at >= 20 && at < changed.size() - kTriangleBytes - 8;
            changed[at] = in_json ? likely[random() % likely.size()] : static_cast<char>(random());
        }
        Diagnostics diagnostics;
        if (!load_gltf(folder.write("changed.glb", changed), diagnostics)) ++refused;
    }
    EXPECT_GT(refused, 100u);
    EXPECT_LT(refused, 1000u);
}

}  // namespace
}  // namespace hm::gltf_test
