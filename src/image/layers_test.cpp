// Layers: what is written comes back, channel for channel, whatever the compression; and the files
// are what OpenEXR's own library says they are.
#include "image/layers.h"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

// Pixel (x, y) of channel n is x + 100 y + 0.25 n, over a part of a larger picture.
LayeredImage test_picture() {
    LayeredImage picture;
    picture.data = {5, 7, 42, 30};
    picture.display = {0, 0, 64, 48};
    float n = 0;
    const auto add = [&](const char* name, const char* channels) {
        const std::size_t count = std::string_view(channels).size();
        std::vector<float> values(picture.data.pixels() * count);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t pixel = i / count;
            values[i] = float(pixel % 37 + 100 * (pixel / 37)) + 0.25f * (n + float(i % count));
        }
        n += float(count);
        picture.layers.push_back(make_layer(name, channels, values));
    };
    add("", "RGBA");
    add("albedo", "RGB");
    add("depth", "Z");
    add("normal", "XYZ");
    add("light.group.a", "RGB");
    picture.metadata = {{"software", "Himalaya"}, {"seed", "7"}};
    return picture;
}

void expect_same(const LayeredImage& a, const LayeredImage& b) {
    EXPECT_EQ(a.data, b.data);
    EXPECT_EQ(a.display, b.display);
    ASSERT_EQ(a.layers.size(), b.layers.size());
    for (const Layer& layer : a.layers) {
        const Layer* other = b.find(layer.name);
        ASSERT_NE(other, nullptr) << layer.name;
        ASSERT_EQ(layer.channels.size(), other->channels.size()) << layer.name;
        for (std::size_t c = 0; c < layer.channels.size(); ++c) {
            EXPECT_EQ(layer.channels[c].name, other->channels[c].name) << layer.name;
            EXPECT_EQ(layer.channels[c].type, other->channels[c].type) << layer.name;
            EXPECT_EQ(layer.channels[c].values, other->channels[c].values) << layer.name;
        }
    }
}

TEST(LayeredImage, WrittenAreReadAgain) {
    const Folder folder;
    const LayeredImage picture = test_picture();
    for (const ExrCompression compression :
         {ExrCompression::none, ExrCompression::rle, ExrCompression::zips, ExrCompression::zip,
          ExrCompression::piz})
        for (const std::uint32_t tile : {0u, 16u, 64u}) {
            SCOPED_TRACE(testing::Message()
                         << "compression " << int(compression) << " tile " << tile);
            ASSERT_TRUE(is_lossless(compression));
            ASSERT_TRUE(write_layers(folder / "a.exr", picture, {compression, tile}));
            const auto read = read_layers(folder / "a.exr");
            ASSERT_TRUE(read) << read.error().line();
            expect_same(picture, *read);
            EXPECT_EQ(*read->find_metadata("seed"), "7");
            EXPECT_EQ(read->find_metadata("nothing"), nullptr);
        }
}

TEST(LayeredImage, LossyCompressionsComeClose) {
    const Folder folder;
    const LayeredImage picture = test_picture();
    for (const ExrCompression compression :
         {ExrCompression::pxr24, ExrCompression::dwaa, ExrCompression::dwab}) {
        ASSERT_FALSE(is_lossless(compression));
        ASSERT_TRUE(write_layers(folder / "a.exr", picture, {compression, 0}));
        const auto read = read_layers(folder / "a.exr");
        ASSERT_TRUE(read) << read.error().line();
        const auto& before = picture.find("depth")->channels[0].values;
        const auto& after = read->find("depth")->channels[0].values;
        for (std::size_t i = 0; i < before.size(); ++i)
            ASSERT_NEAR(before[i], after[i], 0.01f * before[i] + 0.1f);
    }
}

TEST(LayeredImage, HalfChannels) {
    const Folder folder;
    LayeredImage picture = test_picture();
    auto& channel = picture.layers[1].channels[2];
    channel.type = ChannelType::half;
    channel.values[0] = 1.0f / 3.0f;
    channel.values[1] = 1e9f;
    channel.values[2] = -std::numeric_limits<float>::infinity();
    ASSERT_TRUE(write_layers(folder / "a.exr", picture));
    const auto read = read_layers(folder / "a.exr");
    ASSERT_TRUE(read) << read.error().line();
    const LayerChannel& blue = *read->find("albedo")->find("B");
    EXPECT_EQ(blue.type, ChannelType::half);
    EXPECT_EQ(read->find("albedo")->find("R")->type, ChannelType::float32);
    EXPECT_NEAR(blue.values[0], 1.0f / 3.0f, 1.0f / 4096.0f);
    EXPECT_NE(blue.values[0], 1.0f / 3.0f);
    EXPECT_EQ(blue.values[1], 65504.0f);
    EXPECT_EQ(blue.values[2], -65504.0f);
    EXPECT_EQ(blue.values[5], channel.values[5]);  // a small multiple of a quarter
}

TEST(LayeredImage, ChannelNamesInTheFile) {
    const Folder folder;
    ASSERT_TRUE(write_layers(folder / "a.exr", test_picture(), {ExrCompression::zip, 32}));
    Imf::InputFile file((folder / "a.exr").c_str());
    std::string names;
    const Imf::ChannelList& channels = file.header().channels();
    for (auto c = channels.begin(); c != channels.end(); ++c)
        names += std::string(c.name()) + " ";
    EXPECT_EQ(names,
              "A B G R albedo.B albedo.G albedo.R depth.Z light.group.a.B light.group.a.G "
              "light.group.a.R normal.X normal.Y normal.Z ");
    EXPECT_EQ(file.header().tileDescription().xSize, 32u);
    EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({5, 7}, {41, 29}));
    EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {63, 47}));
}

TEST(LayeredImage, BecomePictures) {
    const LayeredImage picture = test_picture();
    const FloatImage beauty = layer_image(picture, *picture.find(""));
    EXPECT_EQ(beauty.width, 37u);
    EXPECT_EQ(beauty.pixels[38][3], 101.75f);
    EXPECT_EQ(make_layer("", beauty, true).channels[3].values,
              picture.layers[0].channels[3].values);
    EXPECT_EQ(make_layer("", beauty, false).channels.size(), 3u);
    const FloatImage depth = layer_image(picture, *picture.find("depth"));
    EXPECT_EQ(depth.pixels[2][0], 3.75f);
    EXPECT_EQ(depth.pixels[2][2], 3.75f);
    EXPECT_EQ(depth.pixels[2][3], 1.0f);
}

TEST(LayeredImage, BadFilesAreRefused) {
    const Folder folder;
    const auto missing = read_layers(folder / "none.exr");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::unreadable);
    const auto unwritable = write_layers(folder / "none" / "a.exr", test_picture());
    ASSERT_FALSE(unwritable);
    EXPECT_EQ(unwritable.error().kind, ErrorKind::unwritable);

    LayeredImage picture = test_picture();
    const auto encoded = encode_layers(picture, {ExrCompression::zip, 16});
    ASSERT_TRUE(encoded);
    for (std::size_t size = 0; size < encoded->size(); size += 501) {
        const auto cut = decode_layers(std::span(*encoded).first(size), "cut");
        ASSERT_FALSE(cut) << size;
        EXPECT_EQ(cut.error().kind, ErrorKind::invalid);
    }
    std::vector<std::byte> damaged = *encoded;
    for (std::size_t i = 0; i < damaged.size(); i += 13) {
        damaged[i] ^= std::byte(0x81);
        (void)decode_layers(damaged, "damaged");
        damaged[i] ^= std::byte(0x81);
    }
}

}  // namespace
}  // namespace hm
