#include "cli/info_schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "base/files.h"
#include "base/json_document.h"
#include "support/asset_files.h"

namespace hm::test {
namespace {

void expect_matches(const Json& schema, const Json& value);

bool has_type(std::string_view name, JsonType type) {
    return name == "object"    ? type == JsonType::object
           : name == "array"   ? type == JsonType::array
           : name == "string"  ? type == JsonType::text
           : name == "boolean" ? type == JsonType::boolean
           : name == "null"    ? type == JsonType::null
           : name == "integer" ? type == JsonType::integer
                               : type == JsonType::integer || type == JsonType::real;
}

// The schema's "type" is a name or a list of names.
bool type_matches(const Json& schema, JsonType type) {
    if (const auto name = schema.text("type")) return !*name || has_type(**name, type);
    const auto names = schema.texts("type").value();
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return has_type(name, type); });
}

std::optional<Json> member(const Json& object, std::string_view key) {
    return object.at("/" + pointer_token(key));
}

void expect_object_matches(const Json& schema, const Json& value) {
    ASSERT_TRUE(schema.has("required")) << value.pointer();
    const auto required = schema.texts("required").value();
    for (const std::string_view name : required)
        EXPECT_TRUE(value.has(name)) << value.pointer() << " lacks " << name;
    for (const std::string_view key : value.keys()) {
        const auto known = schema.at("/properties/" + pointer_token(key));
        ASSERT_TRUE(known) << value.pointer_of(key) << " is not in the schema";
        expect_matches(*known, *member(value, key));
    }
}

void expect_array_matches(const Json& schema, const Json& value) {
    const std::vector<Json> items = value.elements();
    for (const Json& item : items)
        expect_matches(member(schema, "items").value(), item);
    if (const auto least = schema.integer("minItems").value()) {
        EXPECT_EQ(items.size(), *least) << value.pointer();
    }
}

void expect_matches(const Json& schema, const Json& value) {
    const std::string text = value.compact_text();
    if (schema.has("oneOf")) {
        // Always null or something.
        if (value.type() != JsonType::null) expect_matches(schema.at("/oneOf/1").value(), value);
        return;
    }
    if (const auto constant = member(schema, "const")) {
        EXPECT_EQ(constant->compact_text(), text) << value.pointer();
    }
    if (const auto choices = member(schema, "enum")) {
        const std::vector<Json> known = choices->elements();
        EXPECT_TRUE(std::any_of(known.begin(), known.end(),
                                [&](const Json& one) { return one.compact_text() == text; }))
            << value.pointer() << ": " << text;
    }
    ASSERT_TRUE(type_matches(schema, value.type())) << value.pointer() << ": " << text;
    if (value.type() == JsonType::object) expect_object_matches(schema, value);
    if (value.type() == JsonType::array) expect_array_matches(schema, value);
}

}  // namespace

void expect_fits_schema(const std::string& json) {
    const std::string file = (source_folder() / "docs/info.schema.json").string();
    const auto bytes = read_file(file);
    ASSERT_TRUE(bytes);
    const auto schema = JsonDocument::parse(*bytes, file);
    const auto value = JsonDocument::parse(json, "info");
    ASSERT_TRUE(schema) << schema.error().line();
    ASSERT_TRUE(value) << json;
    expect_matches(schema->root(), value->root());
}

}  // namespace hm::test
