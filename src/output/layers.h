// The finished picture of a film: the beauty and every AOV that it carries, as layers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "film/film.h"
#include "image/layers.h"
#include "output/cryptomatte.h"

namespace hm {

struct LayerChoice {
    std::uint32_t width = 0, height = 0;  // of the whole picture, which the film may be a crop of
    bool alpha = false;                   // the beauty's
    std::vector<std::string> half;        // layers to store in 16 bits, by the names of parse_half
    CryptomatteNames names;               // read where a cryptomatte is chosen
    glm::dvec3 origin{0};                 // added to positions
};

// The picture proper first, then the AOVs in the order of their table; metadata are those of the
// AOVs only.
LayeredImage film_layers(const Film& film, const LayerChoice& choice);

// The depth of a pixel that sees nothing.
inline constexpr float kDepthOfNothing = 1e10f;

// "beauty" and names of AOVs, or "all" that half may hold. Ids, depth and positions are refused:
// they lose their meaning. The error completes a sentence.
tl::expected<std::vector<std::string>, std::string> parse_half(std::string_view text);

}  // namespace hm
