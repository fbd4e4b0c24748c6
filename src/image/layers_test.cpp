// Layers: round trips of every channel with every compression, also checked with the OpenEXR
// library.
#include "image/layers.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

// Pixel (x, y) of channel n is x + 100 y + 0.25 n; the data window is a part of the display window.
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

// Infinity, a NaN with a payload, and values outside the range of half, in channels whose names DWA
// treats as colours.
TEST(LayeredImage, LossyCompressionsTouchTheBeautyAlone) {
    const Folder folder;
    LayeredImage picture = test_picture();
    const float odd[] = {1e6f, -1e-30f, std::numeric_limits<float>::infinity(), std::nanf("17"),
                         16777215.0f};
    for (std::size_t l = 1; l < picture.layers.size(); ++l)
        for (LayerChannel& channel : picture.layers[l].channels)
            std::copy(std::begin(odd), std::end(odd), channel.values.begin() + 40);
    for (LayerChannel& channel : picture.layers[0].channels)
        channel.type = ChannelType::half;
    for (const ExrCompression compression :
         {ExrCompression::pxr24, ExrCompression::b44, ExrCompression::b44a, ExrCompression::dwaa,
          ExrCompression::dwab})
        for (const std::uint32_t tile : {0u, 16u}) {
            ASSERT_FALSE(is_lossless(compression));
            ASSERT_TRUE(write_layers(folder / "a.exr", picture, {compression, tile}));
            const auto read = read_layers(folder / "a.exr");
            ASSERT_TRUE(read) << read.error().line();
            EXPECT_EQ(*read->find_metadata("seed"), "7");
            ASSERT_EQ(read->layers.size(), picture.layers.size());
            for (std::size_t l = 1; l < picture.layers.size(); ++l) {
                const Layer& before = picture.layers[l];
                for (const LayerChannel& channel : before.channels) {
                    const auto* after = read->find(before.name)->find(channel.name);
                    ASSERT_NE(after, nullptr);
                    EXPECT_EQ(std::memcmp(after->values.data(), channel.values.data(),
                                          channel.values.size() * sizeof(float)),
                              0)
                        << before.name << "." << channel.name << " " << int(compression);
                }
            }
            for (std::size_t i = 0; i < picture.data.pixels(); ++i)
                ASSERT_NEAR(read->find("")->find("G")->values[i],
                            picture.layers[0].channels[1].values[i],
                            0.02f * picture.layers[0].channels[1].values[i] + 20.0f);
        }
}

// Files of other programs: 32-bit integers and attributes of all types are preserved.
TEST(LayeredImage, ForeignAttributesAndIntegersAreKept) {
    const Folder folder;
    const Imath::Box2i window({0, 0}, {1, 0});
    Imf::Header header(window, window, 2.0f);
    const Imf::Chromaticities acescg({0.713f, 0.293f}, {0.165f, 0.830f}, {0.128f, 0.044f},
                                     {0.32168f, 0.33767f});
    Imf::addChromaticities(header, acescg);
    Imf::addExpTime(header, 0.02f);
    Imf::addIsoSpeed(header, 400.0f);
    Imf::addWorldToCamera(header, Imath::M44f(3.0f));
    Imf::addComments(header, "by hand");
    header.channels().insert("id", Imf::Channel(Imf::UINT));
    header.channels().insert("R", Imf::Channel(Imf::HALF));
    const std::vector<std::uint32_t> ids = {4294967295u, 16777217u};
    const std::vector<half> red = {half(1.5f), half::posInf()};
    Imf::FrameBuffer frame;
    frame.insert("id", Imf::Slice::Make(Imf::UINT, ids.data(), window));
    frame.insert("R", Imf::Slice::Make(Imf::HALF, red.data(), window));
    {
        Imf::OutputFile file((folder / "foreign.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(1);
    }
    const auto read = read_layers(folder / "foreign.exr");
    ASSERT_TRUE(read) << read.error().line();
    EXPECT_EQ(read->find("")->find("id")->integers, ids);
    ASSERT_TRUE(write_layers(folder / "again.exr", *read));

    Imf::InputFile again((folder / "again.exr").c_str());
    EXPECT_EQ(Imf::chromaticities(again.header()).red, acescg.red);
    EXPECT_EQ(again.header().pixelAspectRatio(), 2.0f);
    EXPECT_EQ(Imf::expTime(again.header()), 0.02f);
    EXPECT_EQ(Imf::isoSpeed(again.header()), 400.0f);
    EXPECT_EQ(Imf::worldToCamera(again.header()), Imath::M44f(3.0f));
    EXPECT_EQ(Imf::comments(again.header()), "by hand");
    std::vector<std::uint32_t> ids_again(2);
    std::vector<half> red_again(2);
    Imf::FrameBuffer back;
    back.insert("id", Imf::Slice::Make(Imf::UINT, ids_again.data(), window));
    back.insert("R", Imf::Slice::Make(Imf::HALF, red_again.data(), window));
    again.setFrameBuffer(back);
    again.readPixels(0, 0);
    EXPECT_EQ(ids_again, ids);
    EXPECT_EQ(red_again[1].bits(), red[1].bits());
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
    EXPECT_EQ(blue.values[2], -std::numeric_limits<float>::infinity());
    EXPECT_EQ(blue.values[5], channel.values[5]);  // a small multiple of 0.25, exact in half
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
