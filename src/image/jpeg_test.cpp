// JPEG: images encoded by libjpeg in each colour space decode to nearly the same values.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

struct JpegOptions {
    J_COLOR_SPACE in = JCS_RGB;
    J_COLOR_SPACE stored = JCS_YCbCr;
    bool progressive = false;
    bool adobe = true;  // write the Adobe marker where libjpeg does by default
};

// `samples` are the components of options.in, row by row. Quality 100.
std::vector<std::byte> encode(std::uint32_t width, std::uint32_t height,
                              std::vector<unsigned char> samples, const JpegOptions& options) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* data = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &data, &size);
    info.image_width = width;
    info.image_height = height;
    info.input_components = int(samples.size() / (std::size_t(width) * height));
    info.in_color_space = options.in;
    jpeg_set_defaults(&info);
    jpeg_set_colorspace(&info, options.stored);
    info.write_Adobe_marker = options.adobe ? info.write_Adobe_marker : FALSE;
    jpeg_set_quality(&info, 100, TRUE);
    if (options.progressive) jpeg_simple_progression(&info);
    jpeg_start_compress(&info, TRUE);
    const std::size_t stride = samples.size() / height;
    for (std::size_t y = 0; y < height; ++y) {
        JSAMPLE* row = &samples[y * stride];
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    const auto* first = reinterpret_cast<const std::byte*>(data);
    std::vector<std::byte> bytes(first, first + size);
    std::free(data);
    jpeg_destroy_compress(&info);
    return bytes;
}

// A single colour over 16 x 16 pixels: at quality 100 a flat block is exact up to rounding (1 for
// the colour conversion, 1 for the quantization of DC).
void expect_flat(const std::vector<unsigned char>& pixel, const JpegOptions& options,
                 const std::array<int, 3>& expected) {
    std::vector<unsigned char> samples;
    for (int i = 0; i < 256; ++i)
        samples.insert(samples.end(), pixel.begin(), pixel.end());
    const Image8 image = read_whole<std::uint8_t>(encode(16, 16, samples, options));
    ASSERT_EQ(image.width, 16u);
    ASSERT_EQ(image.height, 16u);
    for (std::size_t i = 0; i < 256; ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_LE(std::abs(image.pixels[i][c] - expected[c]), 2)
                << "component " << c << " is " << int(image.pixels[i][c]);
        ASSERT_EQ(image.pixels[i][3], 255);
    }
}

TEST(Jpeg, ColourSpaces) {
    expect_flat({90}, {JCS_GRAYSCALE, JCS_GRAYSCALE}, {90, 90, 90});
    expect_flat({200, 100, 30}, {JCS_RGB, JCS_YCbCr}, {200, 100, 30});
    expect_flat({200, 100, 30}, {JCS_RGB, JCS_YCbCr, true}, {200, 100, 30});
    expect_flat({200, 100, 30}, {JCS_RGB, JCS_RGB}, {200, 100, 30});
}

TEST(Jpeg, Inks) {
    // With Adobe's marker 255 is no ink: 200 * 128 / 255 = 100.4, 100 * 128 / 255 = 50.2.
    expect_flat({200, 100, 255, 128}, {JCS_CMYK, JCS_CMYK}, {100, 50, 128});
    expect_flat({200, 100, 255, 128}, {JCS_CMYK, JCS_YCCK}, {100, 50, 128});
    // Without it 255 is full ink.
    expect_flat({55, 155, 0, 127}, {JCS_CMYK, JCS_CMYK, false, false}, {100, 50, 128});
}

std::vector<std::byte> textured(bool progressive) {
    std::vector<unsigned char> samples;
    for (unsigned y = 0; y < 24; ++y)
        for (unsigned x = 0; x < 40; ++x)
            for (const unsigned value : {6 * x, 10 * y, (x * y) % 200})
                samples.push_back(static_cast<unsigned char>(value));
    return encode(40, 24, samples, {JCS_RGB, JCS_YCbCr, progressive});
}

TEST(Jpeg, RowsAreInOrder) {
    const Image8 image = read_whole<std::uint8_t>(textured(false));
    ASSERT_EQ(image.width, 40u);
    ASSERT_EQ(image.height, 24u);
    // Chroma is subsampled here: compare luma at the corners of the gradient only.
    EXPECT_LT(image.pixels[0][0], 40);
    EXPECT_GT(image.pixels[39][0], 190);
    EXPECT_GT(image.pixels[23 * 40][1], 180);
}

TEST(Jpeg, CutIsRefused) {
    expect_cuts_refused(textured(false));
    expect_cuts_refused(textured(true));
}

TEST(Jpeg, DamageIsSurvived) {
    expect_damage_survived(textured(false), 0x40);
    expect_damage_survived(textured(true), 0x01);
}

TEST(Jpeg, HeaderThatLiesIsRefused) {
    auto bytes = textured(false);
    // The frame header: FF C0, length, precision, height, width.
    std::size_t at = 0;
    while (bytes[at] != std::byte(0xFF) || bytes[at + 1] != std::byte(0xC0))
        ++at;
    const auto with_size = [&](unsigned width, unsigned height) {
        bytes[at + 5] = std::byte(height >> 8), bytes[at + 6] = std::byte(height & 255);
        bytes[at + 7] = std::byte(width >> 8), bytes[at + 8] = std::byte(width & 255);
        return read_image(bytes, "lying");
    };
    EXPECT_TRUE(with_size(40, 24));
    const auto refused = [](const Result<AnyImage>& image, const char* why) {
        ASSERT_FALSE(image);
        EXPECT_EQ(image.error().kind, ErrorKind::invalid);
        EXPECT_NE(image.error().message.find(why), std::string::npos) << image.error().line();
    };
    refused(with_size(65500, 65500), "in total");
    refused(with_size(65535, 65535), "");
    refused(with_size(65500, 4000), "too few");
    refused(with_size(40, 240), "remature end");
    refused(with_size(0, 24), "");
}

TEST(Jpeg, TooManyScansAreRefused) {
    // The last scan of a progressive file, repeated: well-formed, but each costs a whole pass.
    auto bytes = textured(true);
    std::size_t last = bytes.size();
    for (std::size_t i = 0; i + 1 < bytes.size(); ++i)
        if (bytes[i] == std::byte(0xFF) && bytes[i + 1] == std::byte(0xDA)) last = i;
    const std::vector<std::byte> scan(bytes.begin() + std::ptrdiff_t(last), bytes.end() - 2);
    std::vector<std::byte> many(bytes.begin(), bytes.end() - 2);
    for (int i = 0; i < 300; ++i)
        many.insert(many.end(), scan.begin(), scan.end());
    many.insert(many.end(), bytes.end() - 2, bytes.end());
    const auto image = read_image(many, "many");
    ASSERT_FALSE(image);
    EXPECT_NE(image.error().message.find("scans"), std::string::npos) << image.error().line();
}

}  // namespace
}  // namespace hm
