// A value in a glTF file together with the JSON pointer (RFC 6901) that leads to it, so every
// complaint says where. Getters check the type; a missing property is not an error unless required.
#pragma once

#include <simdjson.h>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace hm::gltf {

// Nesting allowed in a file. Real ones stay below 20; `extras` may hold anything.
inline constexpr std::size_t kMaxJsonDepth = 256;

// Text from the file as part of a message: quoted and cut to a length fit for one line.
std::string excerpt(std::string_view text);

class Json {
  public:
    // `file` must outlive the value; so must the parser that made `value`.
    Json(simdjson::dom::element value, std::string place, const std::string* file)
        : value_(value), place_(std::move(place)), file_(file) {}

    const std::string& place() const { return place_; }
    std::string place_of(std::string_view key) const;
    bool has(std::string_view key) const;
    std::vector<std::string_view> keys() const;            // in the file's order
    bool leads_to_object(std::string_view pointer) const;  // RFC 6901, from this value on

    // Errors at a property or, with an empty key, at this value itself.
    tl::unexpected<Error> fail(ExitCode code, std::string_view key, std::string message) const;
    tl::unexpected<Error> invalid(std::string_view key, std::string message) const;

    // Of every object that is handed out, "extensions" is an object of objects where it is there.
    Result<std::optional<Json>> object(std::string_view key) const;
    Result<std::optional<Json>> extension(std::string_view name) const;
    // How many objects, this one and all below it, have each extension. `extras` are left out.
    std::map<std::string_view, std::size_t> extension_uses() const;
    // An array of objects, of strings; empty where absent.
    Result<std::vector<Json>> objects(std::string_view key) const;
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
    // Numbers fit a float: glTF's are read into floats everywhere.
    Result<std::optional<float>> number(std::string_view key) const;
    Result<float> number_or(std::string_view key, float fallback) const;
    // An array of exactly out.size() numbers; false, and `out` as it was, where absent.
    Result<bool> numbers(std::string_view key, std::span<float> out) const;
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
    std::optional<simdjson::dom::element> find(std::string_view key) const;
    Result<std::optional<simdjson::dom::array>> array(std::string_view key) const;
    Result<Json> to_object(simdjson::dom::element value, std::string place) const;
    tl::unexpected<Error> mistyped(std::string place, std::string_view expected,
                                   simdjson::dom::element found) const;
    // `place` is a function: texts are made only where something is wrong.
    template <class Place>
    Result<std::uint64_t> to_integer(simdjson::dom::element value, const Place& place) const;
    template <class Place>
    Result<float> to_number(simdjson::dom::element value, const Place& place) const;

    simdjson::dom::element value_;
    std::string place_;
    const std::string* file_;
};

// Parses a whole document; its root must be an object.
Result<Json> parse_json(simdjson::dom::parser& parser, std::span<const std::byte> text,
                        const std::string& file);

}  // namespace hm::gltf
