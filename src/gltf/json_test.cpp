// The JSON below the loader: where values are, and what is no part of the text.
#include "gltf/json.h"

#include <fmt/format.h>

#include "gltf/budget.h"
#include "gltf/document.h"
#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

using gltf::Json;

const std::string kFile = "file";

Result<Json> parse(simdjson::dom::parser& parser, std::string_view text, std::size_t behind = 0) {
    return gltf::parse_json(parser, std::as_bytes(std::span(text)), kFile, behind)
        .map([](const gltf::Document& document) { return document.root; });
}

// The text is at the beginning of a longer one, and the parser may look at that.
TEST(Json, WhatStandsBehindTheTextIsNoPartOfIt) {
    for (std::size_t numbers = 1; numbers < 100; ++numbers) {
        std::string text = "{\"a\":[1";
        for (std::size_t i = 1; i < numbers; ++i)
            text += ",1";
        const std::string closed = text + "]}";
        for (const char* behind : {"]}", "5]}", ",2]}", "\"", "{", "\xFF"}) {
            const std::string rest = behind + std::string(100, ' ');
            const std::string open = text + rest, whole = closed + rest;
            simdjson::dom::parser parser;
            const auto prefix = [](const std::string& of, std::size_t size) {
                return std::string_view(of).substr(0, size);
            };
            EXPECT_FALSE(parse(parser, prefix(open, text.size()), rest.size())) << open;
            const auto root = parse(parser, prefix(whole, closed.size()), rest.size());
            ASSERT_TRUE(root) << whole;
            EXPECT_EQ(root->count("a").value(), numbers);
            EXPECT_EQ(root->number_list("a").value(), std::vector<float>(numbers, 1));
        }
    }
}

TEST(Json, ElementsHavePlaces) {
    simdjson::dom::parser parser;
    const Json root = parse(parser, R"({"a":[{"b":[{},{"c":{"d":true}}]},{}]})").value();
    std::vector<std::string> places;
    ASSERT_TRUE(root.for_each_object("a", [&](const Json& item) -> Result<void> {
        places.push_back(item.pointer());
        return {};
    }));
    EXPECT_EQ(places, (std::vector<std::string>{"/a/0", "/a/1"}));
    const Json inner = root.objects("a").value().at(0).objects("b").value().at(1);
    EXPECT_EQ(inner.pointer_of("c"), "/a/0/b/1/c");
    EXPECT_EQ(inner.object("c").value().value().number("d").error().location, "/a/0/b/1/c/d");
}

TEST(Json, RepeatedKeysOfLongObjects) {
    for (const std::size_t count : {2u, 12u, 13u, 200u}) {
        std::string members = "\"key0\":0";
        for (std::size_t i = 1; i < count; ++i)
            members += fmt::format(",\"key{}\":{}", i, i);
        simdjson::dom::parser parser;
        EXPECT_TRUE(parse(parser, "{\"a\":[1,{" + members + "}]}"));
        const auto twice = parse(parser, "{\"a\":[1,{" + members + ",\"key0\":0}]}");
        ASSERT_FALSE(twice) << count;
        EXPECT_EQ(twice.error().location, "/a/1/key0");
    }
}

TEST(Json, ExtensionsAreCountedOutsideExtras) {
    const std::string_view text = R"({"a":{"extensions":{"X":{"extensions":{"Y":{}}}}},
        "b":[{"extensions":{"X":{}},"extras":{"extensions":{"Z":{}}}},{"extensions":1}]})";
    simdjson::dom::parser parser;
    const auto document = gltf::parse_json(parser, std::as_bytes(std::span(text)), kFile);
    ASSERT_TRUE(document);
    EXPECT_EQ(document->extension_uses, (gltf::ExtensionUses{{"X", 2}, {"Y", 1}}));
}

// The copy that the parser may make, and the strings again.
TEST(Json, MemoryCountsTheTextItself) {
    const std::string spaces(1000, ' ');
    EXPECT_GE(gltf::json_memory(std::as_bytes(std::span(spaces))), 2 * spaces.size());
}

}  // namespace
}  // namespace hm::gltf_test
