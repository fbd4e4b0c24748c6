#include "gltf/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace hm::gltf {
namespace {

namespace dom = simdjson::dom;

constexpr double kMaxInteger = 9007199254740992.0;  // 2^53: every integer below is a double

std::string_view type_name(dom::element_type type) {
    switch (type) {
        case dom::element_type::ARRAY:
            return "an array";
        case dom::element_type::OBJECT:
            return "an object";
        case dom::element_type::STRING:
            return "a string";
        case dom::element_type::BOOL:
            return "a boolean";
        case dom::element_type::NULL_VALUE:
            return "null";
        case dom::element_type::INT64:
        case dom::element_type::UINT64:
        case dom::element_type::DOUBLE:
            return "a number";
    }
    return "something else";
}

std::string element_place(std::string_view array_place, std::size_t i) {
    return fmt::format("{}/{}", array_place, i);
}

// The tokens of a JSON pointer (RFC 6901, 3).
std::string escaped(std::string_view key) {
    std::string out;
    for (const char c : key) {
        if (c == '~' || c == '/')
            out += c == '~' ? "~0" : "~1";
        else
            out += c;
    }
    return out;
}

bool is_compound(dom::element value) {
    const dom::element_type type = value.type();
    return type == dom::element_type::ARRAY || type == dom::element_type::OBJECT;
}

// A key that is in the list twice, or nothing.
std::optional<std::string_view> find_twice(std::span<std::string_view> keys) {
    // Nearly all objects are so short that it costs least to compare all with all.
    constexpr std::size_t kShort = 12;
    if (keys.size() > kShort) {
        std::sort(keys.begin(), keys.end());
        const auto twice = std::adjacent_find(keys.begin(), keys.end());
        return twice == keys.end() ? std::nullopt : std::optional(*twice);
    }
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (std::find(keys.begin(), keys.begin() + std::ptrdiff_t(i), keys[i]) !=
            keys.begin() + std::ptrdiff_t(i))
            return keys[i];
    return std::nullopt;
}

// One walk over a whole document, for what has to be looked for everywhere.
class Survey {
  public:
    explicit Survey(ExtensionUses& uses) : uses_(uses) {}

    // The JSON pointer to the first key that stands twice in its object, if there is one: which of
    // the two values counts would depend on the reader.
    std::optional<std::string> repeated_key(dom::element root) {
        std::string place;
        return visit(root, false, place) ? std::optional(place) : std::nullopt;
    }

  private:
    // Whether a key stands twice in an object, anywhere below `value`, an array or an object: its
    // tokens are put in front of `place`.
    bool visit(dom::element value, bool in_extras, std::string& place) {
        return value.is_array() ? visit_array(value, in_extras, place)
                                : visit_object(value, in_extras, place);
    }
    bool visit_array(dom::array values, bool in_extras, std::string& place);
    bool visit_object(dom::object object, bool in_extras, std::string& place);

    ExtensionUses& uses_;
    std::vector<std::string_view> open_;  // the keys of the objects around
};

bool Survey::visit_array(dom::array values, bool in_extras, std::string& place) {
    std::size_t i = 0;
    for (const dom::element item : values) {
        if (is_compound(item) && visit(item, in_extras, place)) {
            place = fmt::format("/{}{}", i, place);
            return true;
        }
        ++i;
    }
    return false;
}

bool Survey::visit_object(dom::object object, bool in_extras, std::string& place) {
    const std::size_t first = open_.size();
    // The parser's pairs of key and value are slow to make.
    for (auto member = object.begin(), end = object.end(); member != end; ++member) {
        const std::string_view key = member.key();
        open_.push_back(key);
        const dom::element item = member.value();
        if (!is_compound(item)) continue;
        if (key == "extensions" && !in_extras && item.is_object())
            for (const auto& [name, extension] : dom::object(item))
                ++uses_[name];
        if (!visit(item, in_extras || key == "extras", place)) continue;
        place = fmt::format("/{}{}", escaped(key), place);
        return true;
    }
    const auto twice = find_twice(std::span(open_).subspan(first));
    if (twice) place = fmt::format("/{}", escaped(*twice));
    open_.resize(first);
    return twice.has_value();
}

}  // namespace

std::string excerpt(std::string_view text) {
    constexpr std::size_t kLongest = 100;
    if (text.size() <= kLongest) return fmt::format("\"{}\"", text);
    return fmt::format("\"{}...\"", text.substr(0, kLongest));
}

std::string Json::place() const {
    return index_ == kNoElement ? place_ : element_place(place_, index_);
}

std::string Json::place_of(std::string_view key) const {
    return key.empty() ? place() : fmt::format("{}/{}", place(), key);
}

bool Json::has(std::string_view key) const {
    return find(key).has_value();
}

std::vector<std::string_view> Json::keys() const {
    std::vector<std::string_view> out;
    for (const auto& [key, value] : dom::object(value_))
        out.push_back(key);
    return out;
}

bool Json::leads_to_object(std::string_view pointer) const {
    if (pointer.empty()) return value_.is_object();
    dom::element found;
    return value_.at_pointer(pointer).get(found) == simdjson::SUCCESS && found.is_object();
}

tl::unexpected<Error> Json::fail(ExitCode code, std::string_view key, std::string message) const {
    return hm::fail(code, *file_, place_of(key), std::move(message));
}

tl::unexpected<Error> Json::invalid(std::string_view key, std::string message) const {
    return fail(ExitCode::invalid, key, std::move(message));
}

tl::unexpected<Error> Json::mistyped(std::string place, std::string_view expected,
                                     dom::element found) const {
    return hm::fail(ExitCode::invalid, *file_, std::move(place),
                    fmt::format("expected {}, found {}", expected, type_name(found.type())));
}

std::optional<dom::element> Json::look_up(std::string_view key) const {
    dom::element found;
    if (value_.at_key(key).get(found) != simdjson::SUCCESS) return std::nullopt;
    return found;
}

Result<std::optional<dom::array>> Json::array(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    dom::array values;
    if (found->get(values) != simdjson::SUCCESS) return mistyped(place_of(key), "an array", *found);
    return values;
}

Result<void> Json::check_object() {
    if (!value_.is_object()) return mistyped(place(), "an object", value_);
    key_bits_ = 0;
    const dom::object object(value_);
    for (auto member = object.begin(), end = object.end(); member != end; ++member)
        key_bits_ |= bit_of(member.key());
    const auto extensions = find("extensions");
    if (!extensions) return {};
    if (!extensions->is_object()) return mistyped(place_of("extensions"), "an object", *extensions);
    for (const auto& [name, extension] : dom::object(*extensions))
        if (!extension.is_object())
            return mistyped(fmt::format("{}/extensions/{}", place(), escaped(name)), "an object",
                            extension);
    return {};
}

Result<std::optional<Json>> Json::object(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    Json object(*found, place_of(key), file_);
    HM_TRY(object.check_object());
    return object;
}

Result<std::optional<Json>> Json::extension(std::string_view name) const {
    HM_TRY_ASSIGN(const std::optional<Json> extensions, object("extensions"));
    if (!extensions) return std::nullopt;
    return extensions->object(name);
}

Result<std::vector<Json>> Json::objects(std::string_view key) const {
    std::vector<Json> out;
    HM_TRY_ASSIGN(const std::size_t length, count(key));
    out.reserve(length);
    HM_TRY(for_each_object(key, [&](const Json& item) -> Result<void> {
        out.push_back(item);
        return {};
    }));
    return out;
}

Result<std::size_t> Json::count(std::string_view key) const {
    HM_TRY_ASSIGN(const auto& values, array(key));
    if (!values) return std::size_t{0};
    // The parser's own number stops at 2^24 - 1.
    return static_cast<std::size_t>(std::distance(values->begin(), values->end()));
}

Result<std::vector<std::string_view>> Json::texts(std::string_view key) const {
    HM_TRY_ASSIGN(const auto& values, array(key));
    std::vector<std::string_view> out;
    if (!values) return out;
    for (const dom::element value : *values) {
        std::string_view text;
        if (value.get(text) != simdjson::SUCCESS)
            return mistyped(element_place(place_of(key), out.size()), "a string", value);
        out.push_back(text);
    }
    return out;
}

Result<bool> Json::flag(std::string_view key) const {
    const auto found = find(key);
    if (!found) return false;
    bool value = false;
    if (found->get(value) != simdjson::SUCCESS) return mistyped(place_of(key), "a boolean", *found);
    return value;
}

Result<std::optional<std::string_view>> Json::text(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    std::string_view value;
    if (found->get(value) != simdjson::SUCCESS) return mistyped(place_of(key), "a string", *found);
    return value;
}

Result<std::string> Json::name() const {
    HM_TRY_ASSIGN(const auto& value, text("name"));
    return std::string(value.value_or(""));
}

template <class Place>
Result<std::uint64_t> Json::to_integer(dom::element value, const Place& place) const {
    std::uint64_t whole = 0;
    if (value.get(whole) == simdjson::SUCCESS && whole <= std::uint64_t(kMaxInteger)) return whole;
    double number = 0;
    if (value.get(number) != simdjson::SUCCESS) return mistyped(place(), "an integer", value);
    if (number < 0 || number > kMaxInteger || number != std::floor(number))
        return hm::fail(ExitCode::invalid, *file_, place(),
                        fmt::format("expected an integer from 0 to 2^53, found {}", number));
    return static_cast<std::uint64_t>(number);
}

template <class Place>
Result<float> Json::to_number(dom::element value, const Place& place) const {
    double number = 0;
    if (value.get(number) != simdjson::SUCCESS) return mistyped(place(), "a number", value);
    if (std::abs(number) > double(std::numeric_limits<float>::max()))
        return hm::fail(ExitCode::invalid, *file_, place(),
                        fmt::format("{} does not fit a 32-bit float", number));
    return static_cast<float>(number);
}

Result<std::optional<std::uint64_t>> Json::integer(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    return to_integer(*found, [&] { return place_of(key); });
}

Result<std::optional<std::size_t>> Json::index(std::string_view key, std::size_t count,
                                               std::string_view what) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    HM_TRY_ASSIGN(const std::uint64_t value, to_integer(*found, [&] { return place_of(key); }));
    if (value >= count)
        return invalid(key, fmt::format("{} is past the end of the {} {}", value, count, what));
    return static_cast<std::size_t>(value);
}

Result<std::vector<std::size_t>> Json::indices(std::string_view key, std::size_t count,
                                               std::string_view what) const {
    HM_TRY_ASSIGN(const auto& values, array(key));
    std::vector<std::size_t> out;
    if (!values) return out;
    out.reserve(values->size());
    for (const dom::element value : *values) {
        const auto here = [&] { return element_place(place_of(key), out.size()); };
        HM_TRY_ASSIGN(const std::uint64_t index, to_integer(value, here));
        if (index >= count)
            return hm::fail(ExitCode::invalid, *file_, here(),
                            fmt::format("{} is past the end of the {} {}", index, count, what));
        out.push_back(static_cast<std::size_t>(index));
    }
    return out;
}

Result<std::optional<float>> Json::number(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    return to_number(*found, [&] { return place_of(key); });
}

Result<float> Json::number_or(std::string_view key, float fallback) const {
    HM_TRY_ASSIGN(const auto& value, number(key));
    return value.value_or(fallback);
}

Result<std::vector<float>> Json::number_list(std::string_view key) const {
    HM_TRY_ASSIGN(const auto& values, array(key));
    std::vector<float> out;
    if (!values) return out;
    for (const dom::element value : *values) {
        const auto here = [&] { return element_place(place_of(key), out.size()); };
        HM_TRY_ASSIGN(const float number, to_number(value, here));
        out.push_back(number);
    }
    return out;
}

Result<bool> Json::numbers(std::string_view key, std::span<float> out) const {
    HM_TRY_ASSIGN(const auto& values, array(key));
    if (!values) return false;
    if (values->size() != out.size())
        return invalid(key,
                       fmt::format("expected {} numbers, found {}", out.size(), values->size()));
    std::size_t i = 0;
    for (const dom::element value : *values) {
        const auto here = [&] { return element_place(place_of(key), i); };
        HM_TRY_ASSIGN(out[i], to_number(value, here));
        ++i;
    }
    return true;
}

Result<Document> parse_json(dom::parser& parser, std::span<const std::byte> text,
                            const std::string& file, std::size_t readable_behind) {
    const auto reject = [&](std::string message) {
        return hm::fail(ExitCode::invalid, file, "", std::move(message));
    };
    const auto byte = [&](std::size_t i) { return std::to_integer<unsigned>(text[i]); };
    if (text.size() >= 3 && byte(0) == 0xEF && byte(1) == 0xBB && byte(2) == 0xBF)
        return reject("starts with a byte order mark, which glTF forbids");
    if (text.size() >= 2 && (byte(0) == 0xFF || byte(0) == 0xFE) && byte(0) + byte(1) == 0x1FD)
        return reject("is UTF-16 text; glTF is UTF-8");

    if (text.empty()) return reject("is empty");
    simdjson::error_code status = parser.allocate(text.size(), kMaxJsonDepth);
    dom::element root;
    if (status == simdjson::SUCCESS)
        // Where the text can't have the padding that simdjson reads past its end, a copy has it.
        status = parser
                     .parse(reinterpret_cast<const char*>(text.data()), text.size(),
                            readable_behind < simdjson::SIMDJSON_PADDING)
                     .get(root);
    if (status == simdjson::DEPTH_ERROR)
        return reject(fmt::format("is nested more than {} levels deep", kMaxJsonDepth));
    if (status == simdjson::UTF8_ERROR) return reject("is not valid UTF-8");
    if (status == simdjson::EMPTY) return reject("is empty");
    if (status == simdjson::NUMBER_ERROR)
        return reject("is not valid JSON: a number is malformed or beyond a 64-bit float");
    if (status == simdjson::MEMALLOC)
        return hm::fail(ExitCode::unreadable, file, "", "its JSON does not fit in memory");
    if (status != simdjson::SUCCESS)
        return reject(fmt::format("is not valid JSON: {}", simdjson::error_message(status)));
    if (!root.is_object()) return reject("is not a glTF file: its JSON is no object");
    ExtensionUses uses;
    if (const auto place = Survey(uses).repeated_key(root))
        return hm::fail(ExitCode::invalid, file, *place, "stands twice in its object");
    return Document{Json(root, "", &file), std::move(uses)};
}

}  // namespace hm::gltf
