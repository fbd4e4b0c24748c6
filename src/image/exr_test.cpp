// OpenEXR: files written with its library in common layouts are read as linear floats.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <string_view>

#include "image/test_images.h"
#include "image/write.h"

namespace hm {
namespace {

using namespace testing_images;

FloatImage gradient(std::uint32_t width, std::uint32_t height) {
    FloatImage image(width, height);
    for (std::size_t i = 0; i < std::size_t(width) * height * 4; ++i)
        image.pixels[i / 4][i % 4] = 0.25f * float(i % 1000);
    return image;
}

TEST(Exr, WrittenIsReadAgain) {
    const Folder folder;
    FloatImage image = gradient(70, 40);
    image.pixels[5][1] = -2.5f;
    ASSERT_TRUE(write_exr(folder / "a.exr", image, true, {}));
    EXPECT_EQ(read_whole<float>(bytes_of_file(folder / "a.exr")).pixels, image.pixels);

    ASSERT_TRUE(write_exr(folder / "b.exr", image, false, {}));
    const FloatImage opaque = read_whole<float>(bytes_of_file(folder / "b.exr"));
    EXPECT_EQ(opaque.pixels[9][2], image.pixels[9][2]);
    EXPECT_EQ(opaque.pixels[9][3], 1.0f);
}

TEST(Exr, EnvironmentIsCleaned) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    FloatImage image = gradient(2, 2);
    image.pixels[0][0] = -1.0f;
    image.pixels[0][1] = NAN;
    image.pixels[0][2] = kInfinity;
    image.pixels[1][0] = -kInfinity;
    const auto bytes = encode_exr(image, true, {});
    ASSERT_TRUE(bytes);
    ReadWarnings warnings;
    const auto clean = read_environment_image(*bytes, "e", warnings);
    ASSERT_TRUE(clean);
    EXPECT_EQ(clean->pixels[0][0], 0.0f);
    EXPECT_EQ(clean->pixels[0][1], 0.0f);
    EXPECT_EQ(clean->pixels[0][2], 65504.0f);
    EXPECT_EQ(clean->pixels[1][0], 0.0f);
    EXPECT_EQ(clean->pixels[1][1], image.pixels[1][1]);
    EXPECT_EQ(clean->pixels[1][3], 1.0f);
    // read_image keeps the values unchanged.
    EXPECT_TRUE(std::isnan(read_whole<float>(*bytes).pixels[0][1]));
}

TEST(Exr, MetadataSurvives) {
    const Folder folder;
    const Metadata metadata = {{"software", "Himalaya"},     {"two words", "\xC3\xA9 \n"},
                               {"compression", "not a one"}, {"type", "not a part"},
                               {"software", "again"},        {"", "nameless"}};
    ASSERT_TRUE(write_exr(folder / "a.exr", gradient(3, 3), false, metadata));
    Imf::InputFile file((folder / "a.exr").c_str());
    const auto text = [&](const char* name) {
        const auto* attribute = file.header().findTypedAttribute<Imf::StringAttribute>(name);
        return attribute ? attribute->value() : std::string("(none)");
    };
    EXPECT_EQ(text("software"), "Himalaya");
    EXPECT_EQ(text("two_words"), "\xC3\xA9 \n");
    EXPECT_EQ(text("compression_"), "not a one");
    EXPECT_EQ(text("type_"), "not a part");
    EXPECT_EQ(text("software_"), "again");
    EXPECT_EQ(text("_"), "nameless");
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    ASSERT_TRUE(Imf::hasChromaticities(file.header()));
    const Imf::Chromaticities primaries = Imf::chromaticities(file.header());
    EXPECT_EQ(primaries.red, Imath::V2f(0.64f, 0.33f));
    EXPECT_EQ(primaries.white, Imath::V2f(0.3127f, 0.3290f));
}

// A file with the given channels; channel c is 1000 x + 10 y + c at pixel (x, y) of the data
// window.
struct ChannelSpec {
    const char* name;
    Imf::PixelType type;
};

ByteArray make_file(const std::vector<ChannelSpec>& channels, Imath::Box2i window,
                    Imf::Compression compression, bool tiled) {
    const Folder folder;
    const auto path = folder / "made.exr";
    Imf::Header header(Imath::Box2i({0, 0}, {639, 479}), window);
    header.compression() = compression;
    if (tiled) header.setTileDescription(Imf::TileDescription(16, 8, Imf::ONE_LEVEL));
    const auto width = std::size_t(window.max.x - window.min.x + 1);
    const auto height = std::size_t(window.max.y - window.min.y + 1);
    std::vector<std::vector<std::byte>> planes;
    Imf::FrameBuffer frame;
    for (const ChannelSpec& channel : channels) {
        const std::size_t size = channel.type == Imf::HALF ? 2 : 4;
        std::vector<std::byte>& plane = planes.emplace_back(width * height * size);
        for (std::size_t i = 0; i < width * height; ++i) {
            const std::size_t value = 1000 * (i % width) + 10 * (i / width) + planes.size() - 1;
            const auto as_half = Imath::half(float(value));
            const auto as_float = float(value);
            const auto as_uint = std::uint32_t(value);
            const void* from = channel.type == Imf::HALF    ? static_cast<const void*>(&as_half)
                               : channel.type == Imf::FLOAT ? static_cast<const void*>(&as_float)
                                                            : static_cast<const void*>(&as_uint);
            std::memcpy(&plane[i * size], from, size);
        }
        header.channels().insert(channel.name, Imf::Channel(channel.type));
        frame.insert(channel.name,
                     Imf::Slice::Make(channel.type, plane.data(), window, size, width * size));
    }
    if (tiled) {
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(int(height));
    }
    return bytes_of_file(path);
}

// Component c of every pixel is channel `source[c]` of make_file, or one if that is -1.
void expect_channels(const ByteArray& bytes, std::size_t width, std::size_t height,
                     std::array<int, 4> source) {
    const FloatImage image = read_whole<float>(bytes);
    ASSERT_EQ(image.width, width);
    ASSERT_EQ(image.height, height);
    for (std::size_t i = 0; i < width * height; ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            const int expected = int(1000 * (i % width) + 10 * (i / width)) + source[c];
            ASSERT_EQ(image.pixels[i][c], source[c] < 0 ? 1.0f : float(expected))
                << "pixel " << i << " component " << c;
        }
}

const Imath::Box2i kWindow({-3, 5}, {29, 41});  // 33 x 37, offset from the display window
constexpr Imf::PixelType kHalf = Imf::HALF, kFloat = Imf::FLOAT, kUint = Imf::UINT;

TEST(Exr, ChannelsOfEveryType) {
    for (const bool tiled : {false, true}) {
        SCOPED_TRACE(tiled);
        const auto made = [&](const std::vector<ChannelSpec>& channels) {
            return make_file(channels, kWindow, Imf::ZIP_COMPRESSION, tiled);
        };
        expect_channels(made({{"R", kFloat}, {"G", kFloat}, {"B", kFloat}}), 33, 37, {0, 1, 2, -1});
        expect_channels(
            made({{"A", kFloat}, {"B", kUint}, {"G", kFloat}, {"R", kUint}, {"Z", kFloat}}), 33, 37,
            {3, 2, 1, 0});
        expect_channels(made({{"Y", kFloat}}), 33, 37, {0, 0, 0, -1});
        expect_channels(made({{"Y", kUint}, {"A", kFloat}}), 33, 37, {0, 0, 0, 1});
    }
    // Half floats are exact for integers up to 2048, hence a width of two pixels.
    const auto bytes = make_file({{"R", kHalf}, {"G", kHalf}, {"B", kHalf}},
                                 Imath::Box2i({0, 0}, {1, 9}), Imf::PIZ_COMPRESSION, false);
    expect_channels(bytes, 2, 10, {0, 1, 2, -1});
}

TEST(Exr, BlocksOfRowsJoin) {
    // Wide enough to be read in several blocks that are not aligned to the chunks of 32 lines.
    const Imath::Box2i window({0, 0}, {29999, 69});
    expect_channels(make_file({{"Y", kFloat}}, window, Imf::PIZ_COMPRESSION, false), 30000, 70,
                    {0, 0, 0, -1});
}

TEST(Exr, CutIsRefused) {
    for (const bool tiled : {false, true})
        expect_cuts_refused(make_file({{"R", kHalf}, {"G", kHalf}, {"B", kHalf}}, kWindow,
                                      Imf::ZIPS_COMPRESSION, tiled));
}

TEST(Exr, DamageIsSurvived) {
    for (const bool tiled : {false, true})
        expect_damage_survived(make_file({{"Y", kHalf}}, kWindow, Imf::ZIP_COMPRESSION, tiled),
                               0x81);
}

TEST(Exr, HeaderThatLiesIsRefused) {
    const auto good = make_file({{"Y", kHalf}}, kWindow, Imf::ZIP_COMPRESSION, true);
    // Offset of an attribute's value, after its name, type and size.
    const auto value_of = [&](std::string_view name, std::string_view type) {
        const std::string key = std::string(name) + '\0' + std::string(type) + '\0';
        const auto found = std::search(good.begin(), good.end(), key.begin(), key.end(),
                                       [](std::byte a, char b) { return a == std::byte(b); });
        return std::size_t(found - good.begin()) + key.size() + 4;
    };
    const auto expect_refusal = [&](std::size_t at, std::initializer_list<std::int32_t> numbers,
                                    const char* why) {
        ByteArray bytes = good;
        for (const std::int32_t number : numbers) {
            std::memcpy(&bytes[at], &number, 4);
            at += 4;
        }
        const auto image = read_image(bytes, "lying");
        ASSERT_FALSE(image) << why;
        EXPECT_EQ(image.error().kind, ErrorKind::invalid);
        EXPECT_NE(image.error().message.find(why), std::string::npos) << image.error().line();
    };
    const std::size_t window = value_of("dataWindow", "box2i");
    const std::size_t tiles = value_of("tiles", "tiledesc");
    const std::size_t channels = value_of("channels", "chlist");
    expect_refusal(window, {0, 0, 65535, 65535}, "in total");
    expect_refusal(window, {-2147483647 - 1, 0, 2147483647, 0}, "per side");
    expect_refusal(window, {0, 0, -1, 5}, "no pixels");
    expect_refusal(window, {0, 0, 65535, 4095}, "");  // chunks are missing
    expect_refusal(tiles, {2147483647, 2147483647}, "too large");
    expect_refusal(tiles, {65536, 1}, "too large");
    expect_refusal(channels - 4, {2147483647}, "past the end of the file");
    expect_refusal(channels - 4, {-1}, "past the end of the file");
    // The library would read all 16 bytes of the box, or the channels to their end, and interpret
    // what follows as attributes other than the checked ones.
    expect_refusal(window - 4, {6}, "has 6 bytes");
    expect_refusal(value_of("displayWindow", "box2i") - 4, {17}, "has 17 bytes");
    expect_refusal(channels - 4, {18}, "has 18 bytes");
    expect_refusal(value_of("lineOrder", "lineOrder") - 4, {4}, "has 4 bytes");
}

// Found by fuzzing: a displayWindow with a declared size of 6 bytes hid attributes from the check,
// one of them of 1.8 GB, which the library allocated.
TEST(Exr, AttributesBehindAShortBoxAreNotRead) {
    using std::literals::operator""sv;
    constexpr std::string_view kFile =
        "v/1\1\2\2\0\0"
        "channels\0chlist\0\x13\0\0\0Y\0\1\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0\0"
        "dataWindow\0box2i\0\x10\0\0\0"
        "\0\0\0\0\0\0\0\0\0\b\0\0\0\4\0\0"
        "displayWindow\0box2i\0\6\0\0\0"
        "\x10\0\0\0\0\0\0\0\0\0\0\0\0\b\0\0\0\4\0\0lineOrder\0"sv;
    const auto image = read_image(std::as_bytes(std::span(kFile)), "short");
    ASSERT_FALSE(image);
    EXPECT_NE(image.error().message.find("has 6 bytes"), std::string::npos) << image.error().line();
}

}  // namespace
}  // namespace hm
