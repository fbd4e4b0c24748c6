// Cryptomatte, specification 1.2 (Psyop, 2018): mattes for everything that has a name. A name's id
// is its MurmurHash3_32 as a float; a pixel lists ids by falling coverage, two per RGBA layer; the
// manifest in the metadata leads from names to ids.
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

// Names of surfaces, by the number that the film's ids have.
struct CryptomatteNames {
    std::span<const std::string> objects, materials, assets;
};

// The layers NAME00, NAME01 and so on for one of the three cryptomattes, and its metadata. There
// are at least three, and as many as the fullest pixel needs, up to sixteen: coverage sums to the
// share of samples that hit anything.
std::vector<Layer> cryptomatte_layers(const Film& film, Aov aov, const CryptomatteNames& names);
Metadata cryptomatte_metadata(Aov aov, const CryptomatteNames& names);

}  // namespace hm
