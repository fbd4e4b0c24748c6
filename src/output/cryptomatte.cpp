#include "output/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>

#include "base/check.h"
#include "base/json_writer.h"

namespace hm {
namespace {

constexpr std::size_t kMinLayers = 3, kMaxLayers = 16;

std::span<const std::string> names_of(Aov aov, const CryptomatteNames& names) {
    HM_CHECK(aov_info(aov).value == AovValue::ids, "{}", aov_info(aov).name);
    return aov == Aov::crypto_object     ? names.objects
           : aov == Aov::crypto_material ? names.materials
                                         : names.assets;
}

struct Coverage {
    float id, coverage;
};

// By descending coverage, then by id, so that the order of the surfaces has no effect.
std::vector<Coverage> rank_ids(const IdList& list, float weight, std::span<const float> ids) {
    std::map<float, float> counts;
    for (const IdCount& entry : list)
        counts[ids[entry.id]] += entry.count;
    std::vector<Coverage> ranked;
    for (const auto& [id, count] : counts)
        ranked.push_back({id, count / weight});
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const Coverage& a, const Coverage& b) { return a.coverage > b.coverage; });
    return ranked;
}

}  // namespace

// MurmurHash3_x86_32 with seed 0 (Appleby; public domain), on blocks of little-endian words.
std::uint32_t murmur_hash_3(std::string_view text) {
    const auto byte = [&](std::size_t i) { return std::uint32_t(std::uint8_t(text[i])); };
    const auto scramble = [](std::uint32_t k) {
        return std::rotl(k * 0xcc9e2d51u, 15) * 0x1b873593u;
    };
    std::uint32_t hash = 0;
    const std::size_t whole = text.size() / 4 * 4;
    for (std::size_t i = 0; i < whole; i += 4) {
        hash ^= scramble(byte(i) | byte(i + 1) << 8 | byte(i + 2) << 16 | byte(i + 3) << 24);
        hash = std::rotl(hash, 13) * 5 + 0xe6546b64u;
    }
    std::uint32_t rest = 0;
    for (std::size_t i = text.size(); i > whole; --i)
        rest = rest << 8 | byte(i - 1);
    if (whole < text.size()) hash ^= scramble(rest);
    hash ^= std::uint32_t(text.size());
    hash = (hash ^ hash >> 16) * 0x85ebca6bu;
    hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
    return hash ^ hash >> 16;
}

float cryptomatte_id(std::string_view name) {
    std::uint32_t hash = murmur_hash_3(name);
    const std::uint32_t exponent = hash >> 23 & 255;
    if (exponent == 0 || exponent == 255) hash ^= 1u << 23;
    return std::bit_cast<float>(hash);
}

std::vector<Layer> cryptomatte_layers(const Film& film, Aov aov, const CryptomatteNames& names) {
    HM_CHECK(film.ids.size() == film.sums.size(), "{} id lists for {} pixels", film.ids.size(),
             film.sums.size());
    std::vector<float> ids;
    for (const std::string& name : names_of(aov, names))
        ids.push_back(cryptomatte_id(name));
    std::vector<std::vector<Coverage>> pixels;
    std::size_t most = 0;
    for (std::size_t i = 0; i < film.ids.size(); ++i) {
        pixels.push_back(rank_ids(film.ids[i], film.sums[i].weight, ids));
        most = std::max(most, pixels.back().size());
    }
    std::vector<Layer> layers;
    const std::size_t count = std::clamp((most + 1) / 2, kMinLayers, kMaxLayers);
    std::vector<float> values(4 * pixels.size());
    for (std::size_t l = 0; l < count; ++l) {
        for (std::size_t i = 0; i < pixels.size(); ++i)
            for (std::size_t rank = 0; rank < 2; ++rank) {
                const std::size_t at = 2 * l + rank;
                const Coverage none{0, 0};
                const Coverage& c = at < pixels[i].size() ? pixels[i][at] : none;
                values[4 * i + 2 * rank] = c.id;
                values[4 * i + 2 * rank + 1] = c.coverage;
            }
        layers.push_back(
            make_layer(fmt::format("{}{:02}", aov_info(aov).layer, l), "RGBA", values));
    }
    return layers;
}

Metadata cryptomatte_metadata(Aov aov, const CryptomatteNames& names) {
    const std::string layer(aov_info(aov).layer);
    const std::string key =
        "cryptomatte/" + fmt::format("{:08x}", murmur_hash_3(layer)).substr(0, 7) + "/";
    std::map<std::string, std::uint32_t> manifest;
    for (const std::string& name : names_of(aov, names))
        manifest[name] = std::bit_cast<std::uint32_t>(cryptomatte_id(name));
    JsonWriter json(JsonText::exact);
    json.begin_object(JsonLayout::compact);
    for (const auto& [name, id] : manifest)
        json.field(name, fmt::format("{:08x}", id));
    json.end_object();
    return {{key + "name", layer},
            {key + "hash", "MurmurHash3_32"},
            {key + "conversion", "uint32_to_float32"},
            {key + "manifest", json.text()}};
}

}  // namespace hm
