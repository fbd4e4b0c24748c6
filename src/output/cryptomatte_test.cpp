// Cryptomatte: the hash against published values, valid ids, ranking, coverage and metadata.
#include "output/cryptomatte.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>

namespace hm {
namespace {

// Published test vectors of MurmurHash3_x86_32 with seed 0.
TEST(Cryptomatte, HashMatchesPublishedValues) {
    EXPECT_EQ(murmur_hash_3(""), 0u);
    EXPECT_EQ(murmur_hash_3("test"), 0xba6bd213u);
    EXPECT_EQ(murmur_hash_3("Hello, world!"), 0xc0363e43u);
    EXPECT_EQ(murmur_hash_3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

TEST(Cryptomatte, IdsAreNormalFloats) {
    for (int i = 0; i < 20000; ++i)
        ASSERT_TRUE(std::isnormal(cryptomatte_id("object " + std::to_string(i))));
    EXPECT_EQ(std::bit_cast<std::uint32_t>(cryptomatte_id("test")), 0xba6bd213u);
}

AovSelection objects() {
    AovSelection selection;
    selection.aovs = {Aov::crypto_object, Aov::crypto_material};
    return selection;
}

const std::vector<std::string> kObjects = {"cat", "dog", "cat", "a \"quoted\" name",
                                           "e",   "f",   "g",   "h"};
const std::vector<std::string> kMaterials(8, "fur");
const CryptomatteNames kNames{kObjects, kMaterials, kObjects};

// Twelve samples per pixel: the first pixel hit two parts of the cat and the dog, the second
// nothing, the third more objects than fit into three layers.
Film test_film() {
    Film film({0, 0, 3, 1}, objects());
    for (PixelSum& sum : film.sums)
        sum.weight = 12;
    add_id(film.ids[0], 0, 2);
    add_id(film.ids[0], 1, 4);
    add_id(film.ids[0], 2, 3);
    for (std::uint32_t id = 1; id < 8; ++id)
        add_id(film.ids[2], id, 1);
    return film;
}

TEST(Cryptomatte, RanksByCoverage) {
    const std::vector<Layer> layers = cryptomatte_layers(test_film(), Aov::crypto_object, kNames);
    ASSERT_EQ(layers.size(), 4u);  // seven ids in the third pixel
    EXPECT_EQ(layers[0].name, "CryptoObject00");
    EXPECT_EQ(layers[3].name, "CryptoObject03");
    const auto value = [&](std::size_t layer, const char* channel, std::size_t pixel) {
        return layers[layer].find(channel)->values[pixel];
    };
    EXPECT_EQ(value(0, "R", 0), cryptomatte_id("cat"));
    EXPECT_EQ(value(0, "G", 0), 5.0f / 12);
    EXPECT_EQ(value(0, "B", 0), cryptomatte_id("dog"));
    EXPECT_EQ(value(0, "A", 0), 4.0f / 12);
    EXPECT_EQ(value(1, "R", 0), 0.0f);
    for (const char* channel : {"R", "G", "B", "A"})
        EXPECT_EQ(value(0, channel, 1), 0.0f);
    std::map<float, float> seen;
    float coverage = 0;
    for (std::size_t l = 0; l < 4; ++l)
        for (const auto& [id, share] : {std::pair{"R", "G"}, {"B", "A"}}) {
            if (value(l, share, 2) > 0) seen[value(l, id, 2)] = value(l, share, 2);
            coverage += value(l, share, 2);
        }
    EXPECT_EQ(seen.size(), 7u);
    EXPECT_NEAR(coverage, 7.0f / 12, 1e-6f);
}

TEST(Cryptomatte, EqualNamesShareAnId) {
    const std::vector<Layer> layers = cryptomatte_layers(test_film(), Aov::crypto_material, kNames);
    ASSERT_EQ(layers.size(), 3u);
    EXPECT_EQ(layers[0].find("R")->values[2], cryptomatte_id("fur"));
    EXPECT_EQ(layers[0].find("G")->values[2], 7.0f / 12);
}

TEST(Cryptomatte, MetadataFollowTheSpecification) {
    const Metadata metadata = cryptomatte_metadata(Aov::crypto_object, kNames);
    ASSERT_EQ(metadata.size(), 4u);
    // The first seven hexadecimal digits of the hash of the layer's name.
    const std::string key =
        "cryptomatte/" + fmt::format("{:08x}", murmur_hash_3("CryptoObject")).substr(0, 7);
    EXPECT_EQ(metadata[0], (std::pair<std::string, std::string>(key + "/name", "CryptoObject")));
    EXPECT_EQ(metadata[1].second, "MurmurHash3_32");
    EXPECT_EQ(metadata[2].second, "uint32_to_float32");
    EXPECT_EQ(metadata[3].first, key + "/manifest");
    const std::string& manifest = metadata[3].second;
    EXPECT_NE(manifest.find(fmt::format("\"cat\":\"{:08x}\"",
                                        std::bit_cast<std::uint32_t>(cryptomatte_id("cat")))),
              std::string::npos);
    EXPECT_NE(manifest.find("\"a \\\"quoted\\\" name\":"), std::string::npos) << manifest;
}

}  // namespace
}  // namespace hm
