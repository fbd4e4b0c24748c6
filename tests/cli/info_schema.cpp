#include "cli/info_schema.h"

#include <gtest/gtest.h>
#include <simdjson.h>

#include "support/asset_files.h"

namespace hm::test {

namespace {

namespace dom = simdjson::dom;

void expect_matches(dom::element schema, dom::element value, const std::string& pointer);

bool has_type(std::string_view type, dom::element value) {
    const bool integer = value.is_uint64() || value.is_int64();
    return type == "object"    ? value.is_object()
           : type == "array"   ? value.is_array()
           : type == "string"  ? value.is_string()
           : type == "boolean" ? value.is_bool()
           : type == "null"    ? value.is_null()
           : type == "integer" ? integer
                               : integer || value.is_double();
}

bool type_matches(dom::element type, dom::element value) {
    if (type.is_string()) return has_type(type.get_string().value(), value);
    for (const dom::element one : type.get_array())
        if (has_type(one.get_string().value(), value)) return true;
    return false;
}

void expect_object_matches(dom::element schema, dom::object value, const std::string& pointer) {
    dom::array required;
    ASSERT_EQ(schema["required"].get(required), simdjson::SUCCESS) << pointer;
    for (const dom::element name : required)
        EXPECT_EQ(value.at_key(name.get_string().value()).error(), simdjson::SUCCESS)
            << pointer << " lacks " << name;
    for (const auto& [key, field] : value) {
        dom::element known;
        const std::string here = pointer + "/" + std::string(key);
        ASSERT_EQ(schema["properties"].at_key(key).get(known), simdjson::SUCCESS)
            << here << " is not in the schema";
        expect_matches(known, field, here);
    }
}

void expect_matches(dom::element schema, dom::element value, const std::string& pointer) {
    dom::element keyword;
    if (schema["oneOf"].get(keyword) == simdjson::SUCCESS) {
        // Always null or something.
        if (!value.is_null()) expect_matches(keyword.at(1).value(), value, pointer);
        return;
    }
    if (schema["const"].get(keyword) == simdjson::SUCCESS) {
        EXPECT_EQ(simdjson::minify(keyword), simdjson::minify(value)) << pointer;
    }
    if (schema["enum"].get(keyword) == simdjson::SUCCESS) {
        bool known = false;
        for (const dom::element one : keyword.get_array())
            known = known || simdjson::minify(one) == simdjson::minify(value);
        EXPECT_TRUE(known) << pointer << ": " << value;
    }
    if (schema["type"].get(keyword) == simdjson::SUCCESS) {
        ASSERT_TRUE(type_matches(keyword, value)) << pointer << ": " << value;
    }
    if (value.is_object()) expect_object_matches(schema, value.get_object().value(), pointer);
    if (!value.is_array()) return;
    std::size_t count = 0;
    for (const dom::element item : value.get_array())
        expect_matches(schema["items"].value(), item, pointer + "/" + std::to_string(count++));
    if (schema["minItems"].get(keyword) == simdjson::SUCCESS) {
        EXPECT_EQ(count, keyword.get_uint64().value()) << pointer;
    }
}

}  // namespace

void expect_fits_schema(const std::string& json) {
    dom::parser schema_parser, parser;
    dom::element schema, value;
    ASSERT_EQ(schema_parser.load((source_folder() / "docs/info.schema.json").string()).get(schema),
              simdjson::SUCCESS);
    ASSERT_EQ(parser.parse(json).get(value), simdjson::SUCCESS) << json;
    expect_matches(schema, value, "");
}

}  // namespace hm::test
