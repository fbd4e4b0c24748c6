// OpenEXR files as environments: windows, chromaticities, parts, layers and rejected files.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "image/color_space.h"
#include "image/read.h"
#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

const Imath::Box2i kFour({0, 0}, {3, 1});  // 4 x 2 pixels

// Channel c of pixel (x, y) of the data window is 100 c + 10 y + x.
struct Part {
    Imf::Header header;
    std::vector<std::string> channels;
};

Part make_part(const Imath::Box2i& display, const Imath::Box2i& data,
               std::vector<std::string> channels) {
    Part part{Imf::Header(display, data), std::move(channels)};
    for (const std::string& channel : part.channels)
        part.header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    return part;
}

ByteArray write(std::vector<Part> parts) {
    const Folder folder;
    const std::string path = (folder / "made.exr").string();
    std::vector<std::vector<float>> values;
    const auto frame_of = [&](const Part& part) {
        const Imath::Box2i data = part.header.dataWindow();
        const auto width = std::size_t(data.max.x - data.min.x + 1);
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < part.channels.size(); ++c) {
            std::vector<float>& plane = values.emplace_back();
            for (int y = data.min.y; y <= data.max.y; ++y)
                for (int x = data.min.x; x <= data.max.x; ++x)
                    plane.push_back(100.0f * float(c) + 10.0f * float(y) + float(x));
            frame.insert(part.channels[c],
                         Imf::Slice::Make(Imf::FLOAT, plane.data(), data, 4, 4 * width));
        }
        return frame;
    };
    const auto rows = [](const Part& part) {
        return part.header.dataWindow().max.y - part.header.dataWindow().min.y + 1;
    };
    if (parts.size() == 1) {
        Imf::OutputFile file(path.c_str(), parts[0].header);
        file.setFrameBuffer(frame_of(parts[0]));
        file.writePixels(rows(parts[0]));
    } else {
        std::vector<Imf::Header> headers;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            parts[p].header.setName("part" + std::to_string(p));
            parts[p].header.setType(Imf::SCANLINEIMAGE);
            headers.push_back(parts[p].header);
        }
        Imf::MultiPartOutputFile file(path.c_str(), headers.data(), int(headers.size()));
        for (std::size_t p = 0; p < parts.size(); ++p) {
            Imf::OutputPart part(file, int(p));
            part.setFrameBuffer(frame_of(parts[p]));
            part.writePixels(rows(parts[p]));
        }
    }
    return bytes_of_file(path);
}

struct Environment {
    FloatImage image;
    ReadWarnings warnings;
};

Environment read(Bytes bytes) {
    Environment environment;
    auto image = read_environment_image(bytes, "e", environment.warnings);
    EXPECT_TRUE(image) << image.error().line();
    if (image) environment.image = *image;
    return environment;
}

void expect_refusal(Bytes bytes, std::string_view why) {
    ReadWarnings warnings;
    const auto image = read_environment_image(bytes, "e", warnings);
    ASSERT_FALSE(image) << why;
    EXPECT_EQ(image.error().kind, ErrorKind::unsupported) << image.error().line();
    EXPECT_NE(image.error().message.find(why), std::string::npos) << image.error().line();
}

TEST(ExrEnvironment, ThePictureIsTheDisplayWindow) {
    const Imath::Box2i display({-2, 3}, {5, 6});  // 8 x 4
    const auto expect_at = [&](const Imath::Box2i& data, std::size_t warnings) {
        const Environment e = read(write({make_part(display, data, {"R", "G", "B"})}));
        ASSERT_EQ(e.image.width, 8u);
        ASSERT_EQ(e.image.height, 4u);
        EXPECT_EQ(e.warnings.size(), warnings);
        for (int y = 3; y <= 6; ++y)
            for (int x = -2; x <= 5; ++x) {
                const bool stored = data.intersects(Imath::V2i(x, y));
                const Rgba<float>& pixel =
                    e.image.pixels[std::size_t(y - 3) * 8 + std::size_t(x + 2)];
                const float value = stored ? 110.0f + 10.0f * float(y - 1) + float(x) : 0.0f;
                EXPECT_EQ(pixel[1], value) << x << ", " << y;
                EXPECT_EQ(pixel[3], 1.0f);
            }
    };
    expect_at(display, 0);
    expect_at(Imath::Box2i({1, 4}, {3, 5}), 1);     // cropped: black around it
    expect_at(Imath::Box2i({-9, 0}, {12, 30}), 0);  // overscan is cropped
    expect_at(Imath::Box2i({4, 5}, {12, 30}), 1);
}

TEST(ExrEnvironment, ChromaticitiesAreConverted) {
    const auto with = [](const Imf::Chromaticities& c, std::vector<std::string> channels) {
        Part part = make_part(kFour, kFour, std::move(channels));
        Imf::addChromaticities(part.header, c);
        return read(write({part}));
    };
    using Imath::V2f;
    const Imf::Chromaticities ap0({0.7347f, 0.2653f}, {0.0f, 1.0f}, {0.0001f, -0.077f},
                                  {0.32168f, 0.33767f});
    const Imf::Chromaticities ap1({0.713f, 0.293f}, {0.165f, 0.830f}, {0.128f, 0.044f},
                                  {0.32168f, 0.33767f});
    const Imf::Chromaticities rec2020({0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f},
                                      {0.3127f, 0.3290f});
    for (const Imf::Chromaticities& c : {ap0, ap1, rec2020}) {
        const Environment grey = with(c, {"Y"});
        for (std::size_t i = 0; i < grey.image.pixels.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(grey.image.pixels[i][k], float(10 * (i / 4) + i % 4), 1e-4);
    }
    EXPECT_EQ(with(Imf::Chromaticities(), {"R", "G", "B"}).image.pixels[1][0], 1.0f);
    Part nonsense = make_part(kFour, kFour, {"Y"});
    Imf::addChromaticities(nonsense.header, Imf::Chromaticities({0, 0}, {0, 0}, {0, 0}, {0, 0}));
    ReadWarnings warnings;
    EXPECT_FALSE(read_environment_image(write({nonsense}), "e", warnings));
}

// Published matrices: ITU-R BT.2087, BT.2020 to BT.709; ACEScg to linear sRGB with Bradford
// adaptation (as in colour science packages).
TEST(ColorSpace, MatricesArePublishedOnes) {
    const auto expect_rows = [](const Chromaticities& from, const Matrix3& expected) {
        const auto matrix = to_rec709(from);
        ASSERT_TRUE(matrix);
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR((*matrix)[r][c], expected[r][c], 1e-4) << r << c;
    };
    expect_rows(
        {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}},
        {{{1.6605, -0.5876, -0.0728}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1187}}});
    expect_rows(
        {{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}},
        {{{1.7051, -0.6218, -0.0833}, {-0.1303, 1.1408, -0.0105}, {-0.0240, -0.1290, 1.1530}}});
    EXPECT_TRUE(is_rec709(kRec709));
    EXPECT_FALSE(to_rec709({{0.3, 0.3}, {0.3, 0.3}, {0.3, 0.3}, {0.3, 0.3}}));
}

TEST(ExrEnvironment, FirstPartWithColours) {
    const Environment e =
        read(write({make_part(kFour, kFour, {"Z"}), make_part(kFour, kFour, {"A", "B", "G", "R"}),
                    make_part(kFour, kFour, {"Y"})}));
    EXPECT_EQ(e.image.pixels[5], (Rgba<float>{311, 211, 111, 1}));
    EXPECT_TRUE(e.warnings.empty());
}

TEST(ExrEnvironment, LayersAndSingleChannels) {
    const Environment layer =
        read(write({make_part(kFour, kFour, {"depth", "Beauty.R", "Beauty.G", "Beauty.B"})}));
    EXPECT_EQ(layer.image.pixels[1], (Rgba<float>{101, 201, 301, 1}));
    ASSERT_EQ(layer.warnings.size(), 1u);
    EXPECT_NE(layer.warnings[0].find("\"Beauty\""), std::string::npos);
    EXPECT_EQ(read(write({make_part(kFour, kFour, {"R"})})).image.pixels[3],
              (Rgba<float>{3, 3, 3, 1}));
    expect_refusal(write({make_part(kFour, kFour, {"R", "G"})}), "G, R");
    expect_refusal(write({make_part(kFour, kFour, {"depth"})}), "depth");
}

TEST(ExrEnvironment, CubeMapsAreRefused) {
    Part cube = make_part(Imath::Box2i({0, 0}, {1, 11}), Imath::Box2i({0, 0}, {1, 11}), {"Y"});
    Imf::addEnvmap(cube.header, Imf::ENVMAP_CUBE);
    expect_refusal(write({cube}), "cube maps");
    Part map = make_part(kFour, kFour, {"Y"});
    Imf::addEnvmap(map.header, Imf::ENVMAP_LATLONG);
    EXPECT_EQ(read(write({map})).image.pixels[1][0], 1.0f);
}

TEST(ExrEnvironment, CodecsOfLaterVersionsAreNamed) {
    ByteArray bytes = write({make_part(kFour, kFour, {"Y"})});
    const std::string_view key("compression\0compression\0\1\0\0\0", 28);
    const auto found = std::search(bytes.begin(), bytes.end(), key.begin(), key.end(),
                                   [](std::byte a, char b) { return a == std::byte(b); });
    ASSERT_NE(found, bytes.end());
    const std::pair<int, const char*> later[] = {
        {10, "HTJ2K256"}, {11, "HTJ2K32"}, {12, "LJ2K"}, {13, "ZSTD"}, {14, "number 14"}};
    for (const auto& [codec, name] : later) {
        *(found + 28) = std::byte(codec);
        expect_refusal(bytes, name);
    }
}

TEST(ExrEnvironment, ReplacedValuesAreCounted) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    FloatImage image(2, 2);
    image.pixels[0] = {kInfinity, kInfinity, 1, 1};
    image.pixels[1] = {std::numeric_limits<float>::quiet_NaN(), -1, -kInfinity, 1};
    const auto bytes = encode_exr(image, false, {});
    ASSERT_TRUE(bytes);
    const Environment e = read(*bytes);
    ASSERT_EQ(e.warnings.size(), 1u);
    EXPECT_NE(e.warnings[0].find("2 infinite, 1 NaN, 2 negative"), std::string::npos)
        << e.warnings[0];
}

}  // namespace
}  // namespace hm
