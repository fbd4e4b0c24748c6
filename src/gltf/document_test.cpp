// glTF documents: extensions, their counts and the memory estimate.
#include "gltf/document.h"

#include "gltf/budget.h"
#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

Result<JsonDocument> parse(std::string_view text) {
    return gltf::parse_document(std::as_bytes(std::span(text)), "file");
}

TEST(Document, ExtensionsAreCountedOutsideExtras) {
    const auto document = parse(R"({"a":{"extensions":{"X":{"extensions":{"Y":{}}}}},
        "b":[{"extensions":{"X":{}},"extras":{"extensions":{"Z":{}}}},{"extensions":1}]})");
    ASSERT_TRUE(document);
    EXPECT_EQ(document->key_counts(), (KeyCounts{{"X", 2}, {"Y", 1}}));
}

TEST(Document, ExtensionsOfReturnedObjectsAreObjects) {
    const auto document = parse(R"({"a":{"extensions":{"X":{"y":5}}},"b":{"extensions":1},
        "c":{"extensions":{"X":{},"Y/Z":2}}})");
    ASSERT_TRUE(document);
    const Json& root = document->root();
    const Json a = root.object("a").value().value();
    EXPECT_EQ(gltf::extension_of(a, "X").value().value().number("y").value(), 5.0f);
    EXPECT_FALSE(gltf::extension_of(a, "Y").value());
    EXPECT_EQ(root.object("b").error().location, "/b/extensions");
    EXPECT_EQ(root.object("c").error().location, "/c/extensions/Y~1Z");
}

// The parser's copy of the text, and the strings.
TEST(Document, MemoryCountsTheTextItself) {
    const std::string spaces(1000, ' ');
    EXPECT_GE(gltf::json_memory(std::as_bytes(std::span(spaces))), 2 * spaces.size());
}

}  // namespace
}  // namespace hm::gltf_test
