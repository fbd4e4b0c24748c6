// Cryptomatte, specification 1.2 (Psyop, 2018): mattes for named objects, materials and assets. The
// id of a name is its MurmurHash3_32 as a float. A pixel lists ids by descending coverage, two per
// RGBA layer. The manifest in the metadata maps names to ids.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "film/film.h"
#include "image/layers.h"

namespace hm {

std::uint32_t murmur_hash_3(std::string_view text);

// The hash's bits as a float that is neither denormal, infinite nor NaN.
float cryptomatte_id(std::string_view name);

// Names of surfaces, indexed by the ids of the film.
struct CryptomatteNames {
    std::span<const std::string> objects, materials, assets;
};

// The layers NAME00, NAME01, ... of one of the three cryptomattes, and its metadata. The pixel with
// the most ids determines the number of layers, which is 3 to 16. If all ids fit, a pixel's
// coverages sum to the share of its samples that hit anything.
std::vector<Layer> cryptomatte_layers(const Film& film, Aov aov, const CryptomatteNames& names);
Metadata cryptomatte_metadata(Aov aov, const CryptomatteNames& names);

}  // namespace hm
