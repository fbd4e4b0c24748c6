#include "corpus/rules.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "corpus/reasons.h"

namespace hm::corpus {

Added& Added::expect(const Expected& expected) {
    for (std::size_t i = first_; i < cases_.size(); ++i)
        cases_[i].expected = expected;
    return *this;
}

Added& Added::silent(const Silence& reason) {
    for (std::size_t i = first_; i < cases_.size(); ++i)
        cases_[i].validator_silence = reason;
    return *this;
}

std::string Object::pointer(std::string_view key) const {
    return key.empty() ? place_ : fmt::format("{}/{}", place_, key);
}

Added Object::rule(std::string_view slug, std::string_view rule, Edits edits, Expected expected) {
    Case c;
    c.file = fmt::format("{}-{}.gltf", name_, slug);
    c.rule = rule;
    c.section = section_;
    c.base = base_;
    c.edits = std::move(edits);
    c.expected = std::move(expected);
    cases_.push_back(std::move(c));
    return {cases_, cases_.size() - 1};
}

Added Object::value(std::string_view key, std::string_view slug, std::string_view json,
                    std::string_view text, std::string_view message) {
    return rule(fmt::format("{}-{}", key, slug), fmt::format("{}: {}", key, text),
                {set(pointer(key), std::string(json))},
                refused(pointer(key), std::string(message)));
}

Added Object::wrong_type(std::string_view key, std::string_view json, std::string_view type,
                         std::string_view found) {
    return value(key, "type", json, fmt::format("is {}", type),
                 fmt::format("expected {}, found {}", type, found));
}

Added Object::required(std::string_view key) {
    return rule(fmt::format("{}-missing", key), fmt::format("{}: is required", key),
                {drop(pointer(key))}, refused(pointer(key), "is required"));
}

Added Object::flag(std::string_view key) {
    return wrong_type(key, "1", "a boolean", "a number");
}

Added Object::text(std::string_view key) {
    return wrong_type(key, "7", "a string", "a number");
}

Added Object::integer(std::string_view key) {
    Added added = wrong_type(key, R"("1")", "an integer", "a string");
    value(key, "negative", "-1", "is not negative", "expected an integer from 0 to 2^53");
    value(key, "fraction", "0.5", "is an integer", "expected an integer from 0 to 2^53");
    return added;
}

Added Object::choice(std::string_view key) {
    Added added = wrong_type(key, R"("1")", "an integer", "a string");
    value(key, "fraction", "0.5", "is an integer", "expected an integer from 0 to 2^53");
    unlisted(key, "negative", "-1", "is not negative", "expected an integer from 0 to 2^53");
    return added;
}

Added Object::unlisted(std::string_view key, std::string_view slug, std::string_view json,
                       std::string_view text, std::string_view message) {
    return value(key, slug, json, text, message).silent(kListed);
}

Added Object::index(std::string_view key) {
    Added added = integer(key);
    value(key, "past-end", "99", "is the index of something that exists", "is past the end of");
    return added;
}

Added Object::number(std::string_view key) {
    return wrong_type(key, R"("1")", "a number", "a string");
}

Added Object::object(std::string_view key) {
    return wrong_type(key, "[]", "an object", "an array");
}

Added Object::objects(std::string_view key) {
    Added added = wrong_type(key, "{}", "an array", "an object");
    rule(fmt::format("{}-element-type", key), fmt::format("{}: elements are objects", key),
         {set(pointer(key), "[null]")},
         refused(pointer(key) + "/0", "expected an object, found null"));
    return added;
}

Added Object::indices(std::string_view key) {
    Added added = wrong_type(key, "0", "an array", "a number");
    rule(fmt::format("{}-element-type", key), fmt::format("{}: elements are integers", key),
         {set(pointer(key), R"(["0"])")},
         refused(pointer(key) + "/0", "expected an integer, found a string"));
    rule(fmt::format("{}-negative", key), fmt::format("{}: elements are not negative", key),
         {set(pointer(key), "[-1]")}, refused(pointer(key) + "/0", "expected an integer from 0"));
    rule(fmt::format("{}-past-end", key),
         fmt::format("{}: elements are indices of something that exists", key),
         {set(pointer(key), "[99]")}, refused(pointer(key) + "/0", "is past the end of"));
    return added;
}

Added Object::numbers(std::string_view key, const std::vector<std::string>& valid) {
    const auto array = [&](std::size_t count, std::string_view first) {
        std::string text = fmt::format("[{}", first);
        for (std::size_t i = 1; i < count; ++i)
            text += "," + valid[i % valid.size()];
        return text + "]";
    };
    const std::size_t n = valid.size();
    Added added = wrong_type(key, R"("0")", "an array", "a string");
    value(key, "short", array(n - 1, valid[0]), fmt::format("has {} elements", n),
          fmt::format("expected {} numbers, found {}", n, n - 1));
    value(key, "long", array(n + 1, valid[0]), fmt::format("has {} elements", n),
          fmt::format("expected {} numbers, found {}", n, n + 1));
    rule(fmt::format("{}-element-type", key), fmt::format("{}: elements are numbers", key),
         {set(pointer(key), array(n, "null"))},
         refused(pointer(key) + "/0", "expected a number, found null"));
    return added;
}

Added Object::extensions() {
    const std::size_t first = cases_.size();
    value("extensions", "type", "[]", "is an object", "expected an object, found an array");
    rule("extensions-element-type", "extensions: elements are objects",
         {set(pointer("extensions"), R"({"EXT_a":1})")},
         refused(pointer("extensions/EXT_a"), "expected an object, found a number"));
    return {cases_, first};
}

Added Object::common(bool has_name) {
    const std::size_t first = cases_.size();
    if (has_name) text("name");
    extensions();
    return {cases_, first};
}

Added Object::empty(std::string_view key) {
    return value(key, "empty", "[]", "has at least one element", "");
}

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const auto add :
         {add_root_rules, add_buffer_rules, add_accessor_rules, add_mesh_rules, add_texture_rules,
          add_material_rules, add_camera_rules, add_node_rules, add_animation_rules, add_skin_rules,
          add_light_rules, add_extension_rules, add_text_rules, add_glb_rules, add_uri_rules})
        add(cases);
    std::set<std::string> files;
    std::string twice;
    for (const Case& c : cases)
        if (!files.insert(c.file).second) twice += " " + c.file;
    if (!twice.empty()) throw std::logic_error("twice:" + twice);
    return cases;
}

std::vector<Case> base_cases() {
    std::vector<Case> cases;
    for (const Base base : {Base::minimal, Base::still, Base::moving, Base::extended}) {
        for (const bool glb : {false, true}) {
            Case c;
            c.file = fmt::format("base-{}.{}", static_cast<int>(base), glb ? "glb" : "gltf");
            c.base = base;
            c.glb = glb;
            cases.push_back(std::move(c));
        }
    }
    return cases;
}

}  // namespace hm::corpus
