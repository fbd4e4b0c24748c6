#include "base/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/json_node.h"

namespace hm {
namespace {

namespace dom = simdjson::dom;

constexpr double kMaxFloat = double(std::numeric_limits<float>::max());
// Half a step above: what is smaller rounds to a float. The largest float is often written as
// 3.4028235e38, which is above it.
constexpr double kFloatOverflow = 0x1.ffffffp127;
constexpr double kMaxInteger = 9007199254740992.0;  // 2^53: doubles hold every integer below

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

std::string element_pointer(std::string_view array, std::size_t i) {
    return fmt::format("{}/{}", array, i);
}

// The parser's own count saturates at 2^24 - 1.
std::size_t element_count(JsonNode array) {
    const dom::array values(to_element(array));
    return static_cast<std::size_t>(std::distance(values.begin(), values.end()));
}

}  // namespace

std::string pointer_token(std::string_view key) {
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
    return index_ == kNoElement ? pointer_ : element_pointer(pointer_, index_);
}

std::string Json::pointer_of(std::string_view key) const {
    return key.empty() ? pointer() : fmt::format("{}/{}", pointer(), key);
}

std::vector<std::string_view> Json::keys() const {
    std::vector<std::string_view> out;
    for (const auto& [key, value] : dom::object(to_element(node_)))
        out.push_back(key);
    return out;
}

std::vector<Json> Json::elements() const {
    std::vector<Json> out;
    for (const dom::element value : dom::array(to_element(node_)))
        out.emplace_back(to_node(value), pointer(), context_, out.size());
    return out;
}

std::optional<Json> Json::at(std::string_view pointer) const {
    if (pointer.empty()) return *this;
    dom::element found;
    if (to_element(node_).at_pointer(pointer).get(found) != simdjson::SUCCESS) return std::nullopt;
    return Json(to_node(found), fmt::format("{}{}", this->pointer(), pointer), context_);
}

JsonType Json::type() const {
    switch (to_element(node_).type()) {
        case dom::element_type::ARRAY:
            return JsonType::array;
        case dom::element_type::OBJECT:
            return JsonType::object;
        case dom::element_type::STRING:
            return JsonType::text;
        case dom::element_type::BOOL:
            return JsonType::boolean;
        case dom::element_type::INT64:
        case dom::element_type::UINT64:
            return JsonType::integer;
        case dom::element_type::DOUBLE:
            return JsonType::real;
        case dom::element_type::NULL_VALUE:
            break;
    }
    return JsonType::null;
}

std::string Json::compact_text() const {
    return simdjson::minify(to_element(node_));
}

tl::unexpected<Error> Json::fail(ErrorKind kind, std::string_view key, std::string message) const {
    return hm::fail(kind, context_->file, pointer_of(key), std::move(message));
}

tl::unexpected<Error> Json::invalid(std::string_view key, std::string message) const {
    return fail(ErrorKind::invalid, key, std::move(message));
}

tl::unexpected<Error> Json::mistyped(std::string pointer, std::string_view expected,
                                     JsonNode found) const {
    return hm::fail(
        ErrorKind::invalid, context_->file, std::move(pointer),
        fmt::format("expected {}, found {}", expected, type_name(to_element(found).type())));
}

std::optional<JsonNode> Json::look_up(std::string_view key) const {
    dom::element found;
    if (to_element(node_).at_key(key).get(found) != simdjson::SUCCESS) return std::nullopt;
    return to_node(found);
}

Result<std::optional<JsonNode>> Json::array(std::string_view key) const {
    const auto found = find(key);
    if (found && !to_element(*found).is_array())
        return mistyped(pointer_of(key), "an array", *found);
    return found;
}

Result<void> Json::check_object() {
    if (!to_element(node_).is_object()) return mistyped(pointer(), "an object", node_);
    key_bits_ = 0;
    const dom::object object(to_element(node_));
    for (auto member = object.begin(), end = object.end(); member != end; ++member)
        key_bits_ |= bit_of(member.key());
    if (context_->check_object == nullptr) return {};
    return context_->check_object(*this);
}

Result<void> Json::check_object_of_objects(std::string_view key) const {
    const auto found = find(key);
    if (!found) return {};
    const dom::element outer = to_element(*found);
    if (!outer.is_object()) return mistyped(pointer_of(key), "an object", *found);
    for (const auto& [name, inner] : dom::object(outer))
        if (!inner.is_object())
            return mistyped(fmt::format("{}/{}", pointer_of(key), pointer_token(name)), "an object",
                            to_node(inner));
    return {};
}

Result<void> Json::visit_objects(std::string_view key, Visitor visit, const void* context) const {
    HM_TRY_ASSIGN(const auto values, array(key));
    if (!values) return {};
    const std::string array_pointer = pointer_of(key);
    std::size_t i = 0;
    for (const dom::element value : dom::array(to_element(*values))) {
        Json item(to_node(value), array_pointer, context_, i++);
        HM_TRY(item.check_object());
        HM_TRY(visit(context, item));
    }
    return {};
}

Result<std::optional<Json>> Json::object(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    Json object(*found, pointer_of(key), context_);
    HM_TRY(object.check_object());
    return object;
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
    return element_count(*values);
}

Result<std::vector<std::string_view>> Json::texts(std::string_view key) const {
    HM_TRY_ASSIGN(const auto& values, array(key));
    std::vector<std::string_view> out;
    if (!values) return out;
    for (const dom::element value : dom::array(to_element(*values))) {
        std::string_view text;
        if (value.get(text) != simdjson::SUCCESS)
            return mistyped(element_pointer(pointer_of(key), out.size()), "a string",
                            to_node(value));
        out.push_back(text);
    }
    return out;
}

Result<bool> Json::flag(std::string_view key) const {
    const auto found = find(key);
    if (!found) return false;
    bool value = false;
    if (to_element(*found).get(value) != simdjson::SUCCESS)
        return mistyped(pointer_of(key), "a boolean", *found);
    return value;
}

Result<std::optional<std::string_view>> Json::text(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    std::string_view value;
    if (to_element(*found).get(value) != simdjson::SUCCESS)
        return mistyped(pointer_of(key), "a string", *found);
    return value;
}

template <class Pointer>
Result<std::uint64_t> Json::to_integer(JsonNode node, const Pointer& pointer) const {
    const dom::element value = to_element(node);
    std::uint64_t whole = 0;
    if (value.get(whole) == simdjson::SUCCESS && whole <= std::uint64_t(kMaxInteger)) return whole;
    double number = 0;
    if (value.get(number) != simdjson::SUCCESS) return mistyped(pointer(), "an integer", node);
    if (number < 0 || number > kMaxInteger || number != std::floor(number))
        return hm::fail(ErrorKind::invalid, context_->file, pointer(),
                        fmt::format("expected an integer from 0 to 2^53, found {}", number));
    return static_cast<std::uint64_t>(number);
}

template <class Number, class Pointer>
Result<Number> Json::to_number(JsonNode node, const Pointer& pointer) const {
    const dom::element value = to_element(node);
    double number = 0;
    if (value.get(number) != simdjson::SUCCESS) return mistyped(pointer(), "a number", node);
    if (std::abs(number) >= kFloatOverflow)
        return hm::fail(ErrorKind::invalid, context_->file, pointer(),
                        fmt::format("{} does not fit a 32-bit float", number));
    return static_cast<Number>(std::clamp(number, -kMaxFloat, kMaxFloat));
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
    out.reserve(element_count(*values));
    for (const dom::element value : dom::array(to_element(*values))) {
        const auto here = [&] { return element_pointer(pointer_of(key), out.size()); };
        HM_TRY_ASSIGN(const std::uint64_t index, to_integer(to_node(value), here));
        if (index >= count)
            return hm::fail(ErrorKind::invalid, context_->file, here(),
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

Result<std::optional<double>> Json::real(std::string_view key) const {
    const auto found = find(key);
    if (!found) return std::nullopt;
    double value = 0;
    if (to_element(*found).get(value) != simdjson::SUCCESS)
        return mistyped(pointer_of(key), "a number", *found);
    return value;
}

Result<float> Json::number_or(std::string_view key, float fallback) const {
    HM_TRY_ASSIGN(const auto& value, number(key));
    return value.value_or(fallback);
}

Result<std::vector<float>> Json::number_list(std::string_view key) const {
    HM_TRY_ASSIGN(const auto& values, array(key));
    std::vector<float> out;
    if (!values) return out;
    for (const dom::element value : dom::array(to_element(*values))) {
        const auto here = [&] { return element_pointer(pointer_of(key), out.size()); };
        HM_TRY_ASSIGN(const float number, to_number<float>(to_node(value), here));
        out.push_back(number);
    }
    return out;
}

template <class Number>
Result<bool> Json::read_numbers(std::string_view key, std::span<Number> out) const {
    HM_TRY_ASSIGN(const auto& values, array(key));
    if (!values) return false;
    const std::size_t count = element_count(*values);
    if (count != out.size())
        return invalid(key, fmt::format("expected {} numbers, found {}", out.size(), count));
    std::size_t i = 0;
    for (const dom::element value : dom::array(to_element(*values))) {
        const auto here = [&] { return element_pointer(pointer_of(key), i); };
        HM_TRY_ASSIGN(out[i], to_number<Number>(to_node(value), here));
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

}  // namespace hm
