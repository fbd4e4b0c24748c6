// Parses the values of flags.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/choice.h"
#include "film/film.h"
#include "session/settings.h"
#include "shading/lang.h"

namespace hm::cli {

// The error message follows the flag's name and a colon.
template <class T>
using Parsed = tl::expected<T, std::string>;

struct Size {
    std::uint32_t width = 0, height = 0;
};

// Finite and within [low, high].
Parsed<float> parse_number(std::string_view text, float low, float high);
Parsed<std::uint32_t> parse_integer(std::string_view text, std::uint32_t low, std::uint32_t high);
Parsed<Size> parse_size(std::string_view text);          // "WxH", within image/read.h's limits
Parsed<PixelRect> parse_crop(std::string_view text);     // "X0,Y0,X1,Y1", not empty
Parsed<glm::dvec3> parse_vector(std::string_view text);  // "X,Y,Z"
// Linear "R,G,B", not negative, or "#rrggbb" in sRGB.
Parsed<vec3> parse_color(std::string_view text);

// "auto", "cpu", "vulkan" or "vulkan:N".
Parsed<DeviceChoice> parse_device(std::string_view text);

// One of the names in a table.
template <class T, std::size_t N>
Parsed<T> parse_choice(std::string_view text, const Choice<T> (&choices)[N]) {
    for (const Choice<T>& choice : choices)
        if (text == choice.name) return choice.value;
    return tl::unexpected("\"" + std::string(text) + "\" is not one of " + names_of(choices));
}

}  // namespace hm::cli
