// Radiance HDR: known bytes decode to known values in each of the three encodings.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "image/test_images.h"
#include "image/write.h"

namespace hm {
namespace {

using namespace testing_images;

std::vector<std::byte> file(std::string_view header, std::initializer_list<unsigned> data) {
    std::vector<std::byte> bytes;
    for (const char c : header)
        bytes.push_back(std::byte(c));
    for (const unsigned value : data)
        bytes.push_back(std::byte(value));
    return bytes;
}

const char* const kHeader2x1 = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
const char* const kHeader8x1 = "#?RGBE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n";

void expect_rgb(const FloatImage& image, std::size_t i, float r, float g, float b) {
    ASSERT_LT(i, image.pixels.size());
    EXPECT_EQ(image.pixels[i][0], r) << "pixel " << i;
    EXPECT_EQ(image.pixels[i][1], g) << "pixel " << i;
    EXPECT_EQ(image.pixels[i][2], b) << "pixel " << i;
    EXPECT_EQ(image.pixels[i][3], 1.0f) << "pixel " << i;
}

TEST(Hdr, FlatPixels) {
    const FloatImage image =
        read_whole<float>(file(kHeader2x1, {128, 64, 0, 129, 255, 255, 255, 0}));
    ASSERT_EQ(image.width, 2u);
    ASSERT_EQ(image.height, 1u);
    expect_rgb(image, 0, 1.0f, 0.5f, 0.0f);
    expect_rgb(image, 1, 0.0f, 0.0f, 0.0f);  // exponent 0 is black
}

TEST(Hdr, ExposureAndColourCorrectionDivide) {
    const FloatImage image = read_whole<float>(
        file("#?RADIANCE\r\nEXPOSURE=2\r\nEXPOSURE= 4.0\r\nCOLORCORR=1 0.5 2\r\n\r\n-Y 1 +X 1\r\n",
             {128, 128, 128, 132}));
    expect_rgb(image, 0, 1.0f, 2.0f, 0.5f);  // 8 / (2 * 4), then the channels
}

// Radiance's XYZ has an equal-energy white point, so equal values are grey.
TEST(Hdr, OtherColourSpacesAreConverted) {
    const auto pixel = [](const std::string& variable, std::initializer_list<unsigned> stored) {
        const FloatImage image =
            read_whole<float>(file("#?RADIANCE\n" + variable + "\n\n-Y 1 +X 1\n", stored));
        return image.pixels[0];
    };
    const std::string rec2020 = "PRIMARIES= 0.708 0.292 0.170 0.797 0.131 0.046 0.3127 0.3290";
    for (const std::string& variable : {std::string("FORMAT=32-bit_rle_xyze"), rec2020})
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(pixel(variable, {128, 128, 128, 129})[c], 1.0, 1e-5) << variable;
    EXPECT_NEAR(pixel(rec2020, {0, 128, 0, 129})[1], 1.1329, 1e-4);
    EXPECT_EQ(pixel(rec2020, {0, 128, 0, 129})[0], 0.0f);
    const std::string rec709 = "PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329";
    const std::string unknown = "PRIMARIES=0 0 0 0 0 0 0 0";  // as Photoshop writes
    for (const std::string& variable : {rec709, unknown})
        EXPECT_EQ(pixel(variable, {128, 64, 0, 129}), (Rgba<float>{1.0f, 0.5f, 0.0f, 1.0f}));
}

TEST(Hdr, OldRuns) {
    // A pixel, three repeats of it, another pixel, and 1 + 0 * 256 repeats of that, a count in two
    // bytes.
    const FloatImage image =
        read_whole<float>(file(kHeader8x1, {128, 0, 0, 129, 1, 1, 1, 3, 0,   128, 0, 129, 1, 1,
                                            1,   1, 1, 1,   1, 0, 0, 0, 128, 129, 1, 1,   1, 1}));
    for (std::size_t i = 0; i < 4; ++i)
        expect_rgb(image, i, 1, 0, 0);
    for (std::size_t i = 4; i < 6; ++i)
        expect_rgb(image, i, 0, 1, 0);
    for (std::size_t i = 6; i < 8; ++i)
        expect_rgb(image, i, 0, 0, 1);
}

TEST(Hdr, OldRunsLongerThanAByte) {
    // 1 + 44 + 1 * 256 = 301 pixels.
    const FloatImage image = read_whole<float>(
        file("#?RADIANCE\n\n-Y 1 +X 301\n", {128, 64, 32, 129, 1, 1, 1, 44, 1, 1, 1, 1}));
    for (std::size_t i = 0; i < 301; ++i)
        expect_rgb(image, i, 1.0f, 0.5f, 0.25f);
}

TEST(Hdr, NewRuns) {
    const FloatImage image = read_whole<float>(
        file(kHeader8x1, {2,   2,   0,  8,                                             //
                          136, 128,                                                    // red: a run
                          8,   0,   32, 64, 96, 128, 160, 192, 224, 132, 0, 132, 128,  // blue: two
                          136, 129}));
    for (std::size_t i = 0; i < 8; ++i)
        expect_rgb(image, i, 1.0f, 0.25f * float(i), i < 4 ? 0.0f : 1.0f);
}

TEST(Hdr, BrokenFilesAreRefused) {
    const auto expect_refusal = [](const std::vector<std::byte>& bytes, const char* why,
                                   ErrorKind kind = ErrorKind::invalid) {
        const auto image = read_image(bytes, "f.hdr");
        ASSERT_FALSE(image) << why;
        EXPECT_EQ(image.error().kind, kind);
        EXPECT_NE(image.error().line().find(why), std::string::npos) << image.error().line();
    };
    expect_refusal(file("#?RADIANCE\n\n", {}), "truncated");
    expect_refusal(file("#?RADIANCE\n\n-Y 1 +X two\n", {1, 2, 3, 4}), "is not a resolution");
    expect_refusal(file("#?RADIANCE\n\n-Y 1 +X 2 junk\n", {1, 2, 3, 4}), "is not a resolution");
    expect_refusal(file("#?RADIANCE\n\n-Y 1 +X 99999999999\n", {1, 2, 3, 4}),
                   "is not a resolution");
    expect_refusal(file("#?RADIANCE\n\n+Y 1 +X 1\n", {1, 2, 3, 4}), "pixel order",
                   ErrorKind::unsupported);
    expect_refusal(file("#?RADIANCE\n\n+X 1 -Y 1\n", {1, 2, 3, 4}), "pixel order",
                   ErrorKind::unsupported);
    expect_refusal(file("#?RADIANCE\nFORMAT=32-bit_float\n\n-Y 1 +X 1\n", {1, 2, 3, 4}), "float",
                   ErrorKind::unsupported);
    expect_refusal(file("#?RADIANCE\nPRIMARIES=0 0 0 0\n\n-Y 1 +X 1\n", {1, 2, 3, 4}), "PRIMARIES");
    expect_refusal(file("#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\n", {1, 2, 3, 4}), "EXPOSURE");
    expect_refusal(file("#?RADIANCE\n\n-Y 0 +X 1\n", {}), "no pixels");
    expect_refusal(file("#?RADIANCE\n\n-Y 65536 +X 65536\n", {1, 2, 3, 4}), "in total");
    expect_refusal(file("#?RADIANCE\n\n-Y 65537 +X 1\n", {1, 2, 3, 4}), "per side");
    expect_refusal(file("#?RADIANCE\n\n-Y 4096 +X 65536\n", {1, 2, 3, 4}), "too few");
    expect_refusal(file(kHeader2x1, {1, 1, 1, 1, 5, 5, 5, 5}), "row 0");  // no pixel to repeat
    expect_refusal(file(kHeader2x1, {9, 9, 9, 9, 1, 1, 1, 2}), "row 0");  // run too long
    expect_refusal(file(kHeader8x1, {2, 2, 0, 9, 136, 1}), "wrong width");
    expect_refusal(file(kHeader8x1, {2, 2, 0, 8, 137, 1}), "invalid length");  // run too long
    expect_refusal(file(kHeader8x1, {2, 2, 0, 8, 0, 1}), "invalid length");    // empty literal
}

FloatImage noise(std::uint32_t width, std::uint32_t height) {
    FloatImage image(width, height);
    std::mt19937 random(7);
    for (std::size_t i = 0; i < std::size_t(width) * height; ++i) {
        const bool flat = (i / 5) % 3 == 0;  // runs, short runs and literals
        for (std::size_t c = 0; c < 3; ++c) {
            const int exponent = int(random() % 40) - 20;
            const float value = std::ldexp(float(random() % 1000) / 1000.0f, exponent);
            image.pixels[i][c] = flat ? 0.75f : value;
        }
        image.pixels[i][3] = 1.0f;
    }
    return image;
}

TEST(Hdr, WrittenIsReadAgain) {
    const Folder folder;
    for (const std::uint32_t width : {1u, 7u, 8u, 129u, 640u, 33000u}) {
        SCOPED_TRACE(width);
        const FloatImage image = noise(width, 3);
        ASSERT_TRUE(write_hdr(folder / "a.hdr", image));
        const FloatImage again = read_whole<float>(bytes_of_file(folder / "a.hdr"));
        ASSERT_EQ(again.pixels.size(), image.pixels.size());
        for (std::size_t i = 0; i < std::size_t(width) * 3; ++i) {
            float largest = 0.0f;
            for (std::size_t c = 0; c < 3; ++c)
                largest = std::max(largest, image.pixels[i][c]);
            // Half a step of a mantissa of at least 128.
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(again.pixels[i][c], image.pixels[i][c], largest / 256.0f);
        }
    }
}

TEST(Hdr, WriterTakesAnyFloat) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const float kMax = std::numeric_limits<float>::max();
    const float values[][3] = {{kInfinity, 0, 0}, {NAN, -1, 2},           {kMax, 0, 0},
                               {1e-45f, 0, 0},    {0.99999994f, 0, 0.5f}, {0, 0, 0}};
    FloatImage image(6, 1);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.pixels[i][c] = values[i][c];
    const FloatImage again = read_whole<float>(encode_hdr(image));
    EXPECT_NEAR(again.pixels[0][0], 65504.0f, 256.0f);
    expect_rgb(again, 1, 0, 0, 2);
    EXPECT_GT(again.pixels[2][0], 1.6e38f);  // the maximum of the format is 255 * 2^119
    expect_rgb(again, 3, 0, 0, 0);
    expect_rgb(again, 4, 1, 0, 0.5f);
    expect_rgb(again, 5, 0, 0, 0);
}

TEST(Hdr, CutIsRefused) {
    expect_cuts_refused(encode_hdr(noise(40, 5)));
    expect_cuts_refused(encode_hdr(noise(5, 9)));
}

TEST(Hdr, DamageIsSurvived) {
    expect_damage_survived(encode_hdr(noise(40, 5)), 0x81);
}

}  // namespace
}  // namespace hm
