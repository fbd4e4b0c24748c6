// Converts a film to the layers of its picture: the beauty and every AOV.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "film/film.h"
#include "image/layers.h"
#include "output/cryptomatte.h"

namespace hm {

struct LayerChoice {
    std::uint32_t width = 0, height = 0;  // of the whole picture; the film may be a crop
    bool alpha = false;                   // the beauty's
    std::vector<std::string> half;        // layers to store as half, named as in parse_half
    CryptomatteNames names;               // used if a cryptomatte is selected
    glm::dvec3 origin{0};                 // added to positions
};

// The beauty first, then the AOVs in the order of all_aovs(). The metadata are those of the AOVs
// only.
LayeredImage film_layers(const Film& film, const LayerChoice& choice);

// The depth of a pixel without a hit.
inline constexpr float kDepthOfNothing = 1e10f;

// Parses "beauty" and names of AOVs, or "all" for every layer that may be stored as half. Ids,
// depth and positions are refused, because half is too coarse for them. The error message is a
// predicate.
tl::expected<std::vector<std::string>, std::string> parse_half(std::string_view text);

}  // namespace hm
