#include "app/cli/values.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "image/read.h"
#include "shading/color.h"

namespace hm::cli {
namespace {

// Far more than any scene is wide, and squares of it still fit a float.
constexpr float kFarthest = 1e15f;

tl::unexpected<std::string> wrong(std::string_view text, std::string_view expected) {
    return tl::unexpected(fmt::format("\"{}\" is not {}", text, expected));
}

template <class T>
bool read_whole(std::string_view text, T& value) {
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stopped == end;
}

// Exactly out.size() numbers with `separator` between them.
template <class T>
bool read_list(std::string_view text, char separator, std::span<T> out) {
    for (std::size_t i = 0; i < out.size(); ++i) {
        const bool last = i + 1 == out.size();
        const std::size_t length = last ? text.size() : text.find(separator);
        if (length == std::string_view::npos || !read_whole(text.substr(0, length), out[i]))
            return false;
        text.remove_prefix(last ? length : length + 1);
    }
    return true;
}

}  // namespace

Parsed<float> parse_number(std::string_view text, float low, float high) {
    float value = 0;
    if (!read_whole(text, value) || !std::isfinite(value)) return wrong(text, "a number");
    if (value < low || value > high)
        return wrong(text, fmt::format("within {:g} and {:g}", low, high));
    return value;
}

Parsed<std::uint32_t> parse_integer(std::string_view text, std::uint32_t low, std::uint32_t high) {
    std::uint32_t value = 0;
    if (!read_whole(text, value) || value < low || value > high)
        return wrong(text, fmt::format("a whole number within {} and {}", low, high));
    return value;
}

Parsed<Size> parse_size(std::string_view text) {
    std::array<std::uint32_t, 2> sides{};
    if (!read_list<std::uint32_t>(text, 'x', sides)) return wrong(text, "a size like 1280x720");
    for (const std::uint32_t side : sides)
        if (side == 0 || side > kMaxImageSide)
            return wrong(text, fmt::format("within 1 and {} pixels either way", kMaxImageSide));
    if (std::uint64_t(sides[0]) * sides[1] > kMaxImagePixels)
        return wrong(text, fmt::format("within {} pixels in all", kMaxImagePixels));
    return Size{sides[0], sides[1]};
}

Parsed<PixelRect> parse_crop(std::string_view text) {
    std::array<std::uint32_t, 4> edges{};
    if (!read_list<std::uint32_t>(text, ',', edges))
        return wrong(text, "four pixel positions X0,Y0,X1,Y1");
    const PixelRect crop{edges[0], edges[1], edges[2], edges[3]};
    if (crop.x0 >= crop.x1 || crop.y0 >= crop.y1)
        return wrong(text, "a crop with X0 < X1 and Y0 < Y1");
    return crop;
}

Parsed<glm::dvec3> parse_vector(std::string_view text) {
    std::array<double, 3> v{};
    if (!read_list<double>(text, ',', v)) return wrong(text, "three numbers X,Y,Z");
    for (const double x : v)
        if (!(std::abs(x) <= double(kFarthest)))
            return wrong(text, fmt::format("within {:g}", kFarthest));
    return glm::dvec3(v[0], v[1], v[2]);
}

Parsed<vec3> parse_color(std::string_view text) {
    if (text.starts_with('#')) {
        std::uint32_t hex = 0;
        const char* end = text.data() + text.size();
        const auto [stopped, error] = std::from_chars(text.data() + 1, end, hex, 16);
        if (text.size() != 7 || error != std::errc() || stopped != end)
            return wrong(text, "a colour like #ff8000");
        const auto channel = [&](unsigned shift) {
            return srgb_to_linear(float(hex >> shift & 255u) / 255.0f);
        };
        return vec3(channel(16), channel(8), channel(0));
    }
    std::array<float, 3> c{};
    if (!read_list<float>(text, ',', c)) return wrong(text, "a colour R,G,B or #rrggbb");
    for (const float x : c)
        if (!(x >= 0 && x <= kFarthest)) return wrong(text, "a colour: not negative and finite");
    return vec3(c[0], c[1], c[2]);
}

Parsed<DeviceChoice> parse_device(std::string_view text) {
    if (text == "auto") return DeviceChoice{DeviceChoice::Kind::automatic, {}};
    if (text == "cpu") return DeviceChoice{DeviceChoice::Kind::cpu, {}};
    if (text == "vulkan") return DeviceChoice{DeviceChoice::Kind::vulkan, {}};
    constexpr std::string_view kIndexed = "vulkan:";
    if (text.starts_with(kIndexed)) {
        const Parsed<std::uint32_t> index = parse_integer(text.substr(kIndexed.size()), 0, 9999);
        if (index) return DeviceChoice{DeviceChoice::Kind::vulkan, *index};
    }
    return tl::unexpected(fmt::format("\"{}\" is not one of auto, cpu, vulkan, vulkan:N", text));
}

}  // namespace hm::cli
