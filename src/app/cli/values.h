// The text of a flag's value -> the value, or what is wrong with it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

#include "film/film.h"
#include "shading/lang.h"

namespace hm::cli {

// The error completes a sentence that begins with the flag's name.
template <class T>
using Parsed = tl::expected<T, std::string>;

struct Size {
    std::uint32_t width = 0, height = 0;
};

// Finite and within [low, high].
Parsed<float> parse_number(std::string_view text, float low, float high);
Parsed<std::uint32_t> parse_integer(std::string_view text, std::uint32_t low, std::uint32_t high);
Parsed<Size> parse_size(std::string_view text);       // "WxH", within image/read.h's limits
Parsed<PixelRect> parse_crop(std::string_view text);  // "X0,Y0,X1,Y1", not empty
Parsed<vec3> parse_vector(std::string_view text);     // "X,Y,Z"
// Linear "R,G,B", not negative, or "#rrggbb" in sRGB.
Parsed<vec3> parse_color(std::string_view text);

// One of a few words.
template <class T>
Parsed<T> parse_choice(std::string_view text,
                       std::initializer_list<std::pair<std::string_view, T>> choices) {
    std::string known;
    for (const auto& [name, value] : choices) {
        if (text == name) return value;
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    return tl::unexpected("\"" + std::string(text) + "\" is none of " + known);
}

}  // namespace hm::cli
