// The JSON reader: pointers, types, and where a text ends.
#include "base/json.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/json_document.h"

namespace hm {
namespace {

Result<JsonDocument> parse(std::string_view text, std::size_t behind = 0) {
    return JsonDocument::parse(std::as_bytes(std::span(text)), "file", {.readable_behind = behind});
}

// The parser may read past the text.
TEST(Json, BytesAfterTheTextAreIgnored) {
    for (std::size_t numbers = 1; numbers < 100; ++numbers) {
        std::string text = "{\"a\":[1";
        for (std::size_t i = 1; i < numbers; ++i)
            text += ",1";
        const std::string closed = text + "]}";
        for (const char* behind : {"]}", "5]}", ",2]}", "\"", "{", "\xFF"}) {
            const std::string rest = behind + std::string(100, ' ');
            const std::string open = text + rest, whole = closed + rest;
            const auto prefix = [](const std::string& of, std::size_t size) {
                return std::string_view(of).substr(0, size);
            };
            EXPECT_FALSE(parse(prefix(open, text.size()), rest.size())) << open;
            const auto document = parse(prefix(whole, closed.size()), rest.size());
            ASSERT_TRUE(document) << whole;
            EXPECT_EQ(document->root().count("a").value(), numbers);
            EXPECT_EQ(document->root().number_list("a").value(), std::vector<float>(numbers, 1));
        }
    }
}

TEST(Json, ElementsHavePointers) {
    const JsonDocument document = parse(R"({"a":[{"b":[{},{"c":{"d":true}}]},{}]})").value();
    const Json& root = document.root();
    std::vector<std::string> pointers;
    ASSERT_TRUE(root.for_each_object("a", [&](const Json& item) -> Result<void> {
        pointers.push_back(item.pointer());
        return {};
    }));
    EXPECT_EQ(pointers, (std::vector<std::string>{"/a/0", "/a/1"}));
    const Json inner = root.objects("a").value().at(0).objects("b").value().at(1);
    EXPECT_EQ(inner.pointer_of("c"), "/a/0/b/1/c");
    EXPECT_EQ(inner.object("c").value().value().number("d").error().location, "/a/0/b/1/c/d");
}

TEST(Json, RepeatedKeysOfLongObjects) {
    for (const std::size_t count : {2u, 12u, 13u, 200u}) {
        std::string members = "\"key0\":0";
        for (std::size_t i = 1; i < count; ++i)
            members += fmt::format(",\"key{}\":{}", i, i);
        EXPECT_TRUE(parse("{\"a\":[1,{" + members + "}]}"));
        const auto twice = parse("{\"a\":[1,{" + members + ",\"key0\":0}]}");
        ASSERT_FALSE(twice) << count;
        EXPECT_EQ(twice.error().location, "/a/1/key0");
    }
}

TEST(Json, ValuesOfAnyType) {
    const JsonDocument document =
        parse(R"({"a/b":[null,true,-3,0.5,"x",[],{"k":1e300}],"n":16777217})").value();
    const Json& root = document.root();
    EXPECT_EQ(root.keys(), (std::vector<std::string_view>{"a/b", "n"}));
    std::vector<JsonType> types;
    for (const Json& value : root.at("/a~1b").value().elements())
        types.push_back(value.type());
    EXPECT_EQ(types, (std::vector<JsonType>{JsonType::null, JsonType::boolean, JsonType::integer,
                                            JsonType::real, JsonType::text, JsonType::array,
                                            JsonType::object}));
    const Json object = root.at("/a~1b/6").value();
    EXPECT_EQ(object.pointer(), "/a~1b/6");
    EXPECT_EQ(object.compact_text(), R"({"k":1e+300})");
    EXPECT_EQ(object.real("k").value(), 1e300);
    EXPECT_EQ(object.number("k").error().location, "/a~1b/6/k");  // not a float
    EXPECT_EQ(root.real("n").value(), 16777217.0);
    EXPECT_FALSE(root.at("/a~1b/7"));
    EXPECT_FALSE(root.at("/n/0"));
}

TEST(Json, TheLargestFloatWithTheDigitsThatItIsWrittenWith) {
    constexpr float kMax = std::numeric_limits<float>::max();
    const JsonDocument document =
        parse(R"({"fits":[3.4028235e38,-3.4028235e38],"larger":3.4028236e38})").value();
    EXPECT_EQ(document.root().number_list("fits").value(), (std::vector<float>{kMax, -kMax}));
    EXPECT_EQ(document.root().number("larger").error().location, "/larger");
}

TEST(Json, ObjectsAreCheckedBeforeTheyAreReturned) {
    JsonOptions options;
    options.check_object = [](const Json& object) -> Result<void> {
        if (object.has("bad")) return object.invalid("bad", "is bad");
        return {};
    };
    const std::string_view text = R"({"a":{"bad":1},"b":[{},{"bad":1}],"c":{}})";
    const JsonDocument document =
        JsonDocument::parse(std::as_bytes(std::span(text)), "file", options).value();
    EXPECT_EQ(document.root().object("a").error().location, "/a/bad");
    EXPECT_EQ(document.root().objects("b").error().location, "/b/1/bad");
    EXPECT_TRUE(document.root().object("c"));
}

TEST(Json, TextsThatAreRejected) {
    for (const std::string_view text :
         {"", " ", "{", "{}{}", "[1,]", "{\"a\":1e400}", "\"\xFF\""}) {
        const auto document = JsonDocument::parse(text, "file");
        ASSERT_FALSE(document) << text;
        EXPECT_EQ(document.error().kind, ErrorKind::invalid);
        EXPECT_EQ(document.error().file, "file");
    }
    const std::string deep(kMaxJsonDepth + 1, '[');
    EXPECT_FALSE(JsonDocument::parse(deep + std::string(deep.size(), ']'), "file"));
}

}  // namespace
}  // namespace hm
