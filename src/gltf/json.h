// A value in a glTF file together with the JSON pointer (RFC 6901) that leads to it, so every
// complaint says where. Getters check the type; a missing property is not an error unless required.
#pragma once

#include <simdjson.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace hm::gltf {

// Text from the file as part of a message: quoted and cut to a length fit for one line.
std::string excerpt(std::string_view text);

// A key as a token of a JSON pointer (RFC 6901, 3).
std::string escaped(std::string_view key);

class Json {
  public:
    // `file` must outlive the value; so must the parser that made `value`. With an index the value
    // is an element of the array at `pointer`.
    Json(simdjson::dom::element value, std::string pointer, const std::string* file,
         std::size_t index = kNoElement)
        : value_(value), place_(std::move(pointer)), index_(index), file_(file) {}

    std::string pointer() const;
    std::string pointer_of(std::string_view key) const;
    bool has(std::string_view key) const;
    std::vector<std::string_view> keys() const;            // in the file's order
    bool leads_to_object(std::string_view pointer) const;  // RFC 6901, from this value on

    // Errors at a property or, with an empty key, at this value itself.
    tl::unexpected<Error> fail(ErrorKind kind, std::string_view key, std::string message) const;
    tl::unexpected<Error> invalid(std::string_view key, std::string message) const;

    // Of every object that is handed out, "extensions" is an object of objects where it is there.
    Result<std::optional<Json>> object(std::string_view key) const;
    Result<std::optional<Json>> extension(std::string_view name) const;
    // An array of objects, of strings; empty where absent.
    Result<std::vector<Json>> objects(std::string_view key) const;
    // The same one by one, for lists that are long: calls `visit` with each object, until it fails.
    template <class Visit>
    Result<void> for_each_object(std::string_view key, const Visit& visit) const;
    Result<std::size_t> count(std::string_view key) const;  // of an array; 0 where absent
    Result<std::vector<std::string_view>> texts(std::string_view key) const;

    Result<bool> flag(std::string_view key) const;  // false where absent
    Result<std::optional<std::string_view>> text(std::string_view key) const;
    Result<std::string> name() const;  // the "name" property, empty where absent
    // Not negative and at most 2^53; written with or without a fraction of zero.
    Result<std::optional<std::uint64_t>> integer(std::string_view key) const;
    // An integer below `count`; `what` names the things counted ("accessors").
    Result<std::optional<std::size_t>> index(std::string_view key, std::size_t count,
                                             std::string_view what) const;
    Result<std::vector<std::size_t>> indices(std::string_view key, std::size_t count,
                                             std::string_view what) const;
    // Numbers fit the range of a float. Only nodes read them in double precision.
    Result<std::optional<float>> number(std::string_view key) const;
    Result<float> number_or(std::string_view key, float fallback) const;
    // An array of exactly out.size() numbers; false, and `out` as it was, where absent.
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

    // A bit that tells most keys apart.
    static constexpr std::uint64_t bit_of(std::string_view key) {
        const std::size_t first = key.empty() ? 0 : static_cast<unsigned char>(key[0]);
        return std::uint64_t{1} << ((first + 5 * key.size()) % 64);
    }
    std::optional<simdjson::dom::element> find(std::string_view key) const {
        if ((key_bits_ & bit_of(key)) == 0) return std::nullopt;
        return look_up(key);
    }
    std::optional<simdjson::dom::element> look_up(std::string_view key) const;
    Result<std::optional<simdjson::dom::array>> array(std::string_view key) const;
    Result<void> check_object();  // and note its keys' bits
    tl::unexpected<Error> mistyped(std::string pointer, std::string_view expected,
                                   simdjson::dom::element found) const;
    // `pointer` is a function: texts are made only where something is wrong.
    template <class Place>
    Result<std::uint64_t> to_integer(simdjson::dom::element value, const Place& pointer) const;
    template <class Number, class Place>
    Result<Number> to_number(simdjson::dom::element value, const Place& pointer) const;
    template <class Number>
    Result<bool> read_numbers(std::string_view key, std::span<Number> out) const;

    simdjson::dom::element value_;
    std::string place_;
    std::size_t index_;  // joined to the pointer where somebody asks: most values are never named
    const std::string* file_;
    // Of the object's keys, or all: most properties that are asked for are absent.
    std::uint64_t key_bits_ = ~std::uint64_t{0};
};

template <class Visit>
Result<void> Json::for_each_object(std::string_view key, const Visit& visit) const {
    HM_TRY_ASSIGN(const auto values, array(key));
    if (!values) return {};
    const std::string pointer = pointer_of(key);
    std::size_t i = 0;
    for (const simdjson::dom::element value : *values) {
        Json item(value, pointer, file_, i++);
        HM_TRY(item.check_object());
        HM_TRY(visit(item));
    }
    return {};
}

}  // namespace hm::gltf
