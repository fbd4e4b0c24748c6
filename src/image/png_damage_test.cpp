// PNG files that are truncated, damaged, or have trailing data.
#include <gtest/gtest.h>

#include "image/read.h"
#include "image/test_images.h"
#include "image/test_png.h"

namespace hm {
namespace {

using namespace testing_images;

// Files that libpng and browsers display are read with a warning.
TEST(Png, SurplusIsAWarning) {
    const Image8 image = gradient(16, 9);
    const auto whole = encode_png(image, true, {});
    ASSERT_TRUE(whole);
    const auto read = [&](const std::vector<std::byte>& bytes, std::size_t warning_count) {
        ReadWarnings warnings;
        const auto picture = read_texture_image(bytes, "surplus", warnings);
        ASSERT_TRUE(picture) << picture.error().line();
        EXPECT_EQ(warnings.size(), warning_count);
        EXPECT_EQ(std::get<Image8>(picture->image()).pixels, image.pixels);
    };
    std::vector<std::byte> after_end = *whole;
    after_end.resize(after_end.size() + 64);
    read(after_end, 0);

    // The whole stream twice: trailing bytes in IDAT, then too many rows.
    Bytes rest = Bytes(*whole).subspan(8);
    std::vector<std::byte> stream, start(whole->begin(), whole->begin() + 33);
    for (; rest.size() >= 12;) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length = length << 8 | std::to_integer<std::size_t>(rest[i]);
        if (rest[4] == std::byte('I') && rest[5] == std::byte('D'))
            stream.insert(stream.end(), rest.begin() + 8,
                          rest.begin() + 8 + std::ptrdiff_t(length));
        rest = rest.subspan(12 + length);
    }
    const auto file = [&](const std::vector<std::byte>& data) {
        std::vector<std::byte> bytes = start;
        for (const auto& chunk : {make_chunk("IDAT", data), make_chunk("IEND", {})})
            bytes.insert(bytes.end(), chunk.begin(), chunk.end());
        return bytes;
    };
    read(file(stream), 0);
    std::vector<std::byte> longer = stream;
    longer.resize(longer.size() + 4);
    read(file(longer), 1);
}

// Regression: with a first chunk other than IHDR, the colour type was read from other bytes.
TEST(Png, HeaderComesFirst) {
    const auto bytes = encode_png(gradient(4, 4), true, {});
    ASSERT_TRUE(bytes);
    for (const char* type : {"acTL", "tEXt", "IDAT"}) {
        std::vector<std::byte> late(bytes->begin(), bytes->begin() + 8);
        const auto chunk = make_chunk(type, std::vector<std::byte>(13, std::byte(200)));
        late.insert(late.end(), chunk.begin(), chunk.end());
        late.insert(late.end(), bytes->begin() + 8, bytes->end());
        const auto image = read_image(late, "late");
        ASSERT_FALSE(image);
        EXPECT_EQ(image.error().line(), "late: PNG: invalid IHDR chunk");
    }
}

// Damaged files are rejected, or are read with a warning if no pixel is affected.
TEST(Png, CutOrDamagedNeverChangesAPixel) {
    const Image8 image = gradient(16, 9);
    const auto bytes = encode_png(image, true, {{"a", "b"}});
    ASSERT_TRUE(bytes);
    constexpr std::size_t kPixels = 61;  // offset of IDAT, after IHDR, sRGB and tEXt
    int drawn = 0;
    const auto check = [&](Bytes damaged, std::size_t at) {
        ReadWarnings warnings;
        const auto read = read_texture_image(damaged, "damaged", warnings);
        if (!read) return;
        ++drawn;
        // The decoder skips ancillary chunks without checking them.
        EXPECT_EQ(warnings.size(), at < kPixels ? 0u : 1u) << "byte " << at;
        EXPECT_EQ(std::get<Image8>(read->image()).pixels, image.pixels) << "byte " << at;
    };
    for (std::size_t i = 8; i < bytes->size(); ++i) {
        check(Bytes(*bytes).first(i), i);
        std::vector<std::byte> damaged = *bytes;
        damaged[i] ^= std::byte(0x10);
        check(damaged, i);
    }
    // sRGB and tEXt except their lengths, and every truncation of IEND.
    EXPECT_GE(drawn, 9 + 11 + 12);
}

TEST(Png, HeaderThatLiesIsRefused) {
    const auto lying = [](std::uint32_t width, std::uint32_t height) {
        auto bytes = *encode_png(gradient(16, 9), true, {});
        const auto store = [&](std::size_t at, std::uint32_t value) {
            for (std::size_t i = 0; i < 4; ++i)
                bytes[at + i] = std::byte(value >> (24 - 8 * i) & 255);
        };
        store(16, width);
        store(20, height);
        store(29, checksum(Bytes(bytes).subspan(12, 17)));
        return bytes;
    };
    EXPECT_TRUE(read_image(lying(16, 9), "right"));
    const auto expect_refusal = [&](std::uint32_t width, std::uint32_t height, const char* why) {
        const auto image = read_image(lying(width, height), "lying");
        ASSERT_FALSE(image);
        EXPECT_EQ(image.error().kind, ErrorKind::invalid);
        EXPECT_NE(image.error().message.find(why), std::string::npos) << image.error().line();
    };
    expect_refusal(65536, 65536, "in total");
    expect_refusal(65537, 1, "per side");
    expect_refusal(1u << 20, 1, "per side");
    expect_refusal(0x7FFFFFFF, 0x7FFFFFFF, "");
    expect_refusal(65536, 4096, "too few");
    expect_refusal(16, 10, "");
    expect_refusal(0, 9, "");
}

}  // namespace
}  // namespace hm
