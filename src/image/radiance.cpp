#include "image/radiance.h"

#include <fmt/format.h>

#include <utility>

namespace hm {

float RadianceReader::clean(float value) {
    if (std::isnan(value))
        ++nan_;
    else if (std::isinf(value) && value > 0.0f)
        ++infinite_;
    else if (value < 0.0f)
        ++negative_;
    return clean_radiance(value);
}

Rgba<float> RadianceReader::convert(float r, float g, float b) {
    const Rgba<float> stored = {clean(r), clean(g), clean(b), 1.0f};
    if (!matrix_) return stored;
    Rgba<float> pixel = stored;
    for (std::size_t c = 0; c < 3; ++c) {
        double value = 0;
        for (std::size_t k = 0; k < 3; ++k)
            value += (*matrix_)[c][k] * double(stored[k]);
        // Rounding errors do not count as out of gamut.
        const double rounding = 1e-6 * double(std::max({stored[0], stored[1], stored[2]}));
        if (value < -rounding) ++outside_;
        pixel[c] = clean_radiance(float(value));
    }
    return pixel;
}

void RadianceReader::report(const char* format, ReadWarnings& warnings) const {
    std::string list;
    const auto add = [&list](std::size_t count, const char* what) {
        if (count > 0) list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, what);
    };
    add(infinite_, "infinite");
    add(nan_, "NaN");
    add(negative_, "negative");
    if (!list.empty())
        warnings.push_back(fmt::format("{}: {} values were replaced (infinite: {}, others: 0)",
                                       format, list, kInfiniteRadiance));
    if (outside_ > 0)
        warnings.push_back(fmt::format("{}: {} values outside the Rec. 709 gamut were set to 0",
                                       format, outside_));
}

}  // namespace hm
