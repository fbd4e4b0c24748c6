// The JSON writer: layouts, numbers, strings. The reader checks that what it writes is JSON.
#include "base/json_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "base/json.h"
#include "base/json_document.h"

namespace hm {
namespace {

void write_sample(JsonWriter& json) {
    json.field("a", 1u).key("b").begin_array().value(true).null();
    json.begin_object().end_object().begin_array().end_array();
    json.begin_object().field("c", "d").end_object().end_array();
}

std::string sample(JsonLayout layout) {
    JsonWriter json;
    json.begin_object(layout);
    write_sample(json);
    return json.end_object().text();
}

TEST(JsonWriter, Layouts) {
    EXPECT_EQ(sample(JsonLayout::compact), R"({"a":1,"b":[true,null,{},[],{"c":"d"}]})");
    EXPECT_EQ(sample(JsonLayout::lines), "{\"a\":1,\n\"b\":[true,null,{},[],{\"c\":\"d\"}]}");
    EXPECT_EQ(sample(JsonLayout::indented), R"({
  "a": 1,
  "b": [
    true,
    null,
    {},
    [],
    {
      "c": "d"
    }
  ]
})");
}

TEST(JsonWriter, ALayoutOfAnInnerContainerEndsWithIt) {
    JsonWriter json;
    json.begin_object().key("a").begin_array(JsonLayout::compact).value(1).value(2).end_array();
    json.key("b").begin_array(JsonLayout::lines).value(3).value(4).end_array();
    json.field("c", 5).end_object();
    EXPECT_EQ(json.text(), "{\n  \"a\": [1,2],\n  \"b\": [3,\n4],\n  \"c\": 5\n}");
}

TEST(JsonWriter, Numbers) {
    JsonWriter json;
    json.begin_array(JsonLayout::compact).value(-3).value(std::numeric_limits<std::int64_t>::min());
    json.value(std::numeric_limits<std::uint64_t>::max());
    json.value(1.0 / 3).value(1.0 / 3, 3).value(1.0f / 3).value(0.1f).value(17.0f);
    json.value(double(INFINITY)).value(NAN).raw("[]").end_array();
    EXPECT_EQ(json.text(),
              "[-3,-9223372036854775808,18446744073709551615,0.333333333,0.333,0.33333334,0.1,17,"
              "null,null,[]]");
}

TEST(JsonWriter, FloatsReadBackAsTheyWere) {
    const std::array values = {1e-45f, 0x1.fffffep127f, 0.1f, 16777217.0f, -1.5e-7f};
    JsonWriter json;
    json.begin_object().key("v").values(values).end_object();
    const JsonDocument document = JsonDocument::parse(json.text(), "file").value();
    EXPECT_EQ(document.root().number_list("v").value(),
              std::vector<float>(values.begin(), values.end()));
}

std::string read_back(JsonText strings, std::string_view text) {
    JsonWriter json(strings);
    json.begin_object().field("text", text).end_object();
    const JsonDocument document = JsonDocument::parse(json.text(), "file").value();
    return std::string(document.root().text("text").value().value());
}

TEST(JsonWriter, Strings) {
    const std::string text = "a\"b\\c\n\x1f\u00e9";
    EXPECT_EQ(read_back(JsonText::exact, text), text);
    EXPECT_EQ(read_back(JsonText::printable, text), "a\"b\\c\\x0A\\x1F\u00e9");
    EXPECT_EQ(read_back(JsonText::printable, "\xff"), "\\xFF");  // not UTF-8
}

}  // namespace
}  // namespace hm
