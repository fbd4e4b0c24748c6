#include "gltf/json.h"

#include <fmt/format.h>

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

}  // namespace

std::string excerpt(std::string_view text) {
    constexpr std::size_t kLongest = 100;
    if (text.size() <= kLongest) return fmt::format("\"{}\"", text);
    return fmt::format("\"{}...\"", text.substr(0, kLongest));
}

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

std::string Json::pointer() const {
    return index_ == kNoElement ? place_ : element_place(place_, index_);
}

std::string Json::pointer_of(std::string_view key) const {
    return key.empty() ? pointer() : fmt::format("{}/{}", pointer(), key);
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

tl::unexpected<Error> Json::fail(ErrorKind kind, std::string_view key, std::string message) const {
    return hm::fail(kind, *file_, pointer_of(key), std::move(message));
}

tl::unexpected<Error> Json::invalid(std::string_view key, std::string message) const {
    return fail(ErrorKind::invalid, key, std::move(message));
}

tl::unexpected<Error> Json::mistyped(std::string pointer, std::string_view expected,
                                     dom::element found) const {
    return hm::fail(ErrorKind::invalid, *file_, std::move(pointer),
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
    if (found->get(values) != simdjson::SUCCESS)
        return mistyped(pointer_of(key), "an array", *found);
    return values;
}

Result<void> Json::check_object() {
    if (!value_.is_object()) return mistyped(pointer(), "an object", value_);
    key_bits_ = 0;
    const dom::object object(value_);
    for (auto member = object.begin(), end = object.end(); member != end; ++member)
        key_bits_ |= bit_of(member.key());
    const auto extensions = find("extensions");
    if (!extensions) return {};
    if (!extensions->is_object())
        return mistyped(pointer_of("extensions"), "an object", *extensions);
    for (const auto& [name, extension] : dom::object(*extensions))
        if (!extension.is_object())
            return mistyped(fmt::format("{}/extensions/{}", pointer(), escaped(name)), "an object",
                            extension);
    return {};
}

Result<std::optional<Json>> Json::object(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    Json object(*found, pointer_of(key), file_);
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
            return mistyped(element_place(pointer_of(key), out.size()), "a string", value);
        out.push_back(text);
    }
    return out;
}

Result<bool> Json::flag(std::string_view key) const {
    const auto found = find(key);
    if (!found) return false;
    bool value = false;
    if (found->get(value) != simdjson::SUCCESS)
        return mistyped(pointer_of(key), "a boolean", *found);
    return value;
}

Result<std::optional<std::string_view>> Json::text(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    std::string_view value;
    if (found->get(value) != simdjson::SUCCESS)
        return mistyped(pointer_of(key), "a string", *found);
    return value;
}

Result<std::string> Json::name() const {
    HM_TRY_ASSIGN(const auto& value, text("name"));
    return std::string(value.value_or(""));
}

template <class Place>
Result<std::uint64_t> Json::to_integer(dom::element value, const Place& pointer) const {
    std::uint64_t whole = 0;
    if (value.get(whole) == simdjson::SUCCESS && whole <= std::uint64_t(kMaxInteger)) return whole;
    double number = 0;
    if (value.get(number) != simdjson::SUCCESS) return mistyped(pointer(), "an integer", value);
    if (number < 0 || number > kMaxInteger || number != std::floor(number))
        return hm::fail(ErrorKind::invalid, *file_, pointer(),
                        fmt::format("expected an integer from 0 to 2^53, found {}", number));
    return static_cast<std::uint64_t>(number);
}

template <class Number, class Place>
Result<Number> Json::to_number(dom::element value, const Place& pointer) const {
    double number = 0;
    if (value.get(number) != simdjson::SUCCESS) return mistyped(pointer(), "a number", value);
    if (std::abs(number) > double(std::numeric_limits<float>::max()))
        return hm::fail(ErrorKind::invalid, *file_, pointer(),
                        fmt::format("{} does not fit a 32-bit float", number));
    return static_cast<Number>(number);
}

Result<std::optional<std::uint64_t>> Json::integer(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    return to_integer(*found, [&] { return pointer_of(key); });
}

Result<std::optional<std::size_t>> Json::index(std::string_view key, std::size_t count,
                                               std::string_view what) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    HM_TRY_ASSIGN(const std::uint64_t value, to_integer(*found, [&] { return pointer_of(key); }));
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
        const auto here = [&] { return element_place(pointer_of(key), out.size()); };
        HM_TRY_ASSIGN(const std::uint64_t index, to_integer(value, here));
        if (index >= count)
            return hm::fail(ErrorKind::invalid, *file_, here(),
                            fmt::format("{} is past the end of the {} {}", index, count, what));
        out.push_back(static_cast<std::size_t>(index));
    }
    return out;
}

Result<std::optional<float>> Json::number(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    return to_number<float>(*found, [&] { return pointer_of(key); });
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
        const auto here = [&] { return element_place(pointer_of(key), out.size()); };
        HM_TRY_ASSIGN(const float number, to_number<float>(value, here));
        out.push_back(number);
    }
    return out;
}

template <class Number>
Result<bool> Json::read_numbers(std::string_view key, std::span<Number> out) const {
    HM_TRY_ASSIGN(const auto& values, array(key));
    if (!values) return false;
    if (values->size() != out.size())
        return invalid(key,
                       fmt::format("expected {} numbers, found {}", out.size(), values->size()));
    std::size_t i = 0;
    for (const dom::element value : *values) {
        const auto here = [&] { return element_place(pointer_of(key), i); };
        HM_TRY_ASSIGN(out[i], to_number<Number>(value, here));
        ++i;
    }
    return true;
}

Result<bool> Json::numbers(std::string_view key, std::span<float> out) const {
    return read_numbers(key, out);
}

Result<bool> Json::numbers(std::string_view key, std::span<double> out) const {
    return read_numbers(key, out);
}

}  // namespace hm::gltf
