// A value of a JSON document together with its JSON pointer (RFC 6901), which every error names.
// Getters check types; a missing property is not an error unless required.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace hm {

// A key as a token of a JSON pointer (RFC 6901, 3).
std::string pointer_token(std::string_view key);

enum class JsonType { null, boolean, integer, real, text, array, object };

// Where a value is stored: a parsed document and an index into it. json_node.h converts it to the
// parser's own type, which no other header knows.
struct JsonNode {
    const void* document = nullptr;
    std::size_t index = 0;
};

class Json;

// What all values of a document share.
struct JsonContext {
    std::string file;
    // If set, called with each object before a getter returns it.
    Result<void> (*check_object)(const Json& object) = nullptr;
};

class Json {
  public:
    // Valid while the document lives (json_document.h). With an index the value is an element of
    // the array at `pointer`.
    Json(JsonNode node, std::string pointer, const JsonContext* context,
         std::size_t index = kNoElement)
        : node_(node), pointer_(std::move(pointer)), index_(index), context_(context) {}

    std::string pointer() const;
    std::string pointer_of(std::string_view key) const;
    JsonType type() const;
    std::string compact_text() const;  // as JSON without spaces
    bool has(std::string_view key) const { return find(key).has_value(); }
    std::vector<std::string_view> keys() const;  // of an object, in the file's order
    std::vector<Json> elements() const;          // of an array, of any type
    // The value that a JSON pointer (RFC 6901) leads to from here.
    std::optional<Json> at(std::string_view pointer) const;

    // Errors at a property or, with an empty key, at this value itself.
    tl::unexpected<Error> fail(ErrorKind kind, std::string_view key, std::string message) const;
    tl::unexpected<Error> invalid(std::string_view key, std::string message) const;

    Result<std::optional<Json>> object(std::string_view key) const;
    // Fails if the property exists and is not an object that has only objects as values.
    Result<void> check_object_of_objects(std::string_view key) const;
    // An array of objects; empty where absent.
    Result<std::vector<Json>> objects(std::string_view key) const;
    // Calls `visit` with each object of an array until it fails; cheaper for long arrays.
    template <class Visit>
    Result<void> for_each_object(std::string_view key, const Visit& visit) const {
        const auto call = [](const void* context, const Json& item) -> Result<void> {
            return (*static_cast<const Visit*>(context))(item);
        };
        return visit_objects(key, call, &visit);
    }
    Result<std::size_t> count(std::string_view key) const;  // of an array; 0 where absent
    Result<std::vector<std::string_view>> texts(std::string_view key) const;

    Result<bool> flag(std::string_view key) const;  // false where absent
    Result<std::optional<std::string_view>> text(std::string_view key) const;
    // From 0 to 2^53; a fraction of zero is allowed.
    Result<std::optional<std::uint64_t>> integer(std::string_view key) const;
    // An integer below `count`; `what` names the things counted ("accessors").
    Result<std::optional<std::size_t>> index(std::string_view key, std::size_t count,
                                             std::string_view what) const;
    Result<std::vector<std::size_t>> indices(std::string_view key, std::size_t count,
                                             std::string_view what) const;
    // Fails if the number does not fit a float.
    Result<std::optional<float>> number(std::string_view key) const;
    Result<std::optional<double>> real(std::string_view key) const;
    Result<float> number_or(std::string_view key, float fallback) const;
    // An array of exactly out.size() numbers; false, and `out` unchanged, where absent.
    Result<bool> numbers(std::string_view key, std::span<float> out) const;
    Result<bool> numbers(std::string_view key, std::span<double> out) const;
    // An array of any length; empty where absent.
    Result<std::vector<float>> number_list(std::string_view key) const;

    // Turns an absent property into an error.
    template <class T>
    Result<T> required(std::string_view key, Result<std::optional<T>> found) const {
        if (!found) return tl::unexpected(std::move(found.error()));
        if (!*found) return invalid(key, "is required");
        return std::move(**found);
    }

  private:
    static constexpr std::size_t kNoElement = ~std::size_t{0};

    using Visitor = Result<void> (*)(const void* context, const Json& object);

    // A hash of a key, as one bit of a word.
    static constexpr std::uint64_t bit_of(std::string_view key) {
        const std::size_t first = key.empty() ? 0 : static_cast<unsigned char>(key[0]);
        return std::uint64_t{1} << ((first + 5 * key.size()) % 64);
    }
    std::optional<JsonNode> find(std::string_view key) const {
        if ((key_bits_ & bit_of(key)) == 0) return std::nullopt;
        return look_up(key);
    }
    std::optional<JsonNode> look_up(std::string_view key) const;
    Result<std::optional<JsonNode>> array(std::string_view key) const;
    template <class Number>
    Result<bool> read_numbers(std::string_view key, std::span<Number> out) const;
    Result<void> visit_objects(std::string_view key, Visitor visit, const void* context) const;
    Result<void> check_object();  // also sets key_bits_
    tl::unexpected<Error> mistyped(std::string pointer, std::string_view expected,
                                   JsonNode found) const;
    // `pointer` is a function, so that the text is only made for an error.
    template <class Pointer>
    Result<std::uint64_t> to_integer(JsonNode value, const Pointer& pointer) const;
    template <class Number, class Pointer>
    Result<Number> to_number(JsonNode value, const Pointer& pointer) const;

    JsonNode node_;
    std::string pointer_;
    std::size_t index_;  // appended to the pointer on demand: most values are never named
    const JsonContext* context_;
    // The hashes of the object's keys, or all bits: most properties that are looked up are absent.
    std::uint64_t key_bits_ = ~std::uint64_t{0};
};

}  // namespace hm
