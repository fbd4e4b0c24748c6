// PNG: files of every colour type written by libspng are decoded as the standard defines, and as
// libspng does.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <spng.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <random>

#include "image/test_images.h"
#include "image/test_png.h"
#include "image/write.h"

namespace hm {
namespace {

using namespace testing_images;

constexpr std::size_t kEndBytes = 12;  // IEND, after which there are no pixels

struct PngParts {
    std::uint32_t width = 0, height = 0;
    std::uint8_t depth = 8;
    std::uint8_t type = SPNG_COLOR_TYPE_TRUECOLOR;
    bool interlaced = false;
    std::optional<spng_plte> palette;
    std::optional<spng_trns> transparency;
    std::vector<std::byte> rows;  // as stored, but 16-bit values in native byte order
};

std::vector<std::byte> encode(const PngParts& parts) {
    spng_ctx* context = spng_ctx_new(SPNG_CTX_ENCODER);
    spng_set_option(context, SPNG_ENCODE_TO_BUFFER, 1);
    spng_ihdr header{parts.width,
                     parts.height,
                     parts.depth,
                     parts.type,
                     0,
                     0,
                     std::uint8_t(parts.interlaced ? SPNG_INTERLACE_ADAM7 : SPNG_INTERLACE_NONE)};
    EXPECT_EQ(spng_set_ihdr(context, &header), 0);
    if (parts.palette) {
        spng_plte palette = *parts.palette;
        EXPECT_EQ(spng_set_plte(context, &palette), 0);
    }
    if (parts.transparency) {
        spng_trns transparency = *parts.transparency;
        EXPECT_EQ(spng_set_trns(context, &transparency), 0);
    }
    const int status = spng_encode_image(context, parts.rows.data(), parts.rows.size(),
                                         SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
    EXPECT_EQ(status, 0) << spng_strerror(status);
    std::size_t size = 0;
    int error = 0;
    void* data = spng_get_png_buffer(context, &size, &error);
    EXPECT_EQ(error, 0);
    const auto* first = static_cast<const std::byte*>(data);
    std::vector<std::byte> bytes(first, first + size);
    std::free(data);
    spng_ctx_free(context);
    return bytes;
}

std::vector<std::byte> bytes_from(std::initializer_list<unsigned> values) {
    std::vector<std::byte> bytes;
    for (const unsigned value : values)
        bytes.push_back(std::byte(value));
    return bytes;
}

std::vector<std::byte> bytes_from_16(std::initializer_list<unsigned> values) {
    std::vector<std::byte> bytes;
    for (const unsigned value : values) {
        const auto word = std::uint16_t(value);
        std::byte two[2];
        std::memcpy(two, &word, 2);
        bytes.insert(bytes.end(), two, two + 2);
    }
    return bytes;
}

using Components = std::array<unsigned, 4>;

template <class T>
void expect_pixels_of(const ImageOf<T>& image, const PngParts& parts,
                      const std::vector<Components>& expected) {
    ASSERT_EQ(image.width, parts.width);
    ASSERT_EQ(image.height, parts.height);
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_EQ(unsigned(image.pixels[i][c]), expected[i][c])
                << "pixel " << i << " component " << c;
        }
}

void expect_pixels(const PngParts& parts, const std::vector<Components>& expected) {
    const std::vector<std::byte> png = encode(parts);
    if (parts.depth == 16)
        expect_pixels_of(read_whole<std::uint16_t>(png), parts, expected);
    else
        expect_pixels_of(read_whole<std::uint8_t>(png), parts, expected);
}

TEST(Png, GreyOfEveryDepth) {
    PngParts parts{8, 1, 1, SPNG_COLOR_TYPE_GRAYSCALE, false, {}, {}, bytes_from({0b01100001})};
    expect_pixels(parts,
                  {{0, 0, 0, 255}, {255, 255, 255, 255}, {255, 255, 255, 255}, {0, 0, 0, 255}});
    parts.width = 4, parts.depth = 2, parts.rows = bytes_from({0b00011011});
    expect_pixels(parts,
                  {{0, 0, 0, 255}, {85, 85, 85, 255}, {170, 170, 170, 255}, {255, 255, 255, 255}});
    parts.width = 2, parts.depth = 4, parts.rows = bytes_from({0x3F});
    expect_pixels(parts, {{51, 51, 51, 255}, {255, 255, 255, 255}});
    parts.depth = 8, parts.rows = bytes_from({7, 200});
    expect_pixels(parts, {{7, 7, 7, 255}, {200, 200, 200, 255}});
    parts.depth = 16, parts.rows = bytes_from_16({0x0102, 0xFFFE});
    expect_pixels(parts, {{0x0102, 0x0102, 0x0102, 65535}, {0xFFFE, 0xFFFE, 0xFFFE, 65535}});
}

TEST(Png, GreyWithAlpha) {
    PngParts parts{2,     1,  8,  SPNG_COLOR_TYPE_GRAYSCALE_ALPHA,
                   false, {}, {}, bytes_from({9, 128, 77, 0})};
    expect_pixels(parts, {{9, 9, 9, 128}, {77, 77, 77, 0}});
    parts.depth = 16, parts.rows = bytes_from_16({300, 400, 500, 0});
    expect_pixels(parts, {{300, 300, 300, 400}, {500, 500, 500, 0}});
}

TEST(Png, Truecolour) {
    PngParts parts{2,     1,  8,  SPNG_COLOR_TYPE_TRUECOLOR,
                   false, {}, {}, bytes_from({1, 2, 3, 4, 5, 6})};
    expect_pixels(parts, {{1, 2, 3, 255}, {4, 5, 6, 255}});
    parts.depth = 16, parts.rows = bytes_from_16({1000, 2, 3, 4, 5, 60000});
    expect_pixels(parts, {{1000, 2, 3, 65535}, {4, 5, 60000, 65535}});
    parts.type = SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, parts.width = 1;
    parts.rows = bytes_from_16({1000, 2, 3, 4444});
    expect_pixels(parts, {{1000, 2, 3, 4444}});
    parts.depth = 8, parts.rows = bytes_from({9, 8, 7, 6});
    expect_pixels(parts, {{9, 8, 7, 6}});
}

TEST(Png, PaletteWithTransparency) {
    spng_plte palette{};
    palette.n_entries = 4;
    palette.entries[0] = {10, 20, 30, 255};
    palette.entries[1] = {40, 50, 60, 255};
    palette.entries[2] = {70, 80, 90, 255};
    palette.entries[3] = {1, 2, 3, 255};
    spng_trns transparency{};
    transparency.n_type3_entries = 2;  // later palette entries are opaque
    transparency.type3_alpha[0] = 0;
    transparency.type3_alpha[1] = 99;
    const std::vector<Components> expected = {
        {10, 20, 30, 0}, {40, 50, 60, 99}, {70, 80, 90, 255}, {1, 2, 3, 255}};
    for (const std::uint8_t depth : std::initializer_list<std::uint8_t>{2, 4, 8}) {
        PngParts parts{4, 1, depth, SPNG_COLOR_TYPE_INDEXED, false, palette, transparency, {}};
        parts.rows = depth == 2   ? bytes_from({0b00011011})
                     : depth == 4 ? bytes_from({0x01, 0x23})
                                  : bytes_from({0, 1, 2, 3});
        SCOPED_TRACE(int(depth));
        expect_pixels(parts, expected);
    }
}

TEST(Png, TransparentColour) {
    spng_trns transparency{};
    transparency.gray = 5;
    PngParts parts{2, 1, 4, SPNG_COLOR_TYPE_GRAYSCALE, false, {}, transparency, bytes_from({0x56})};
    expect_pixels(parts, {{85, 85, 85, 0}, {102, 102, 102, 255}});
    transparency.gray = 0x0102;
    parts.transparency = transparency;
    parts.depth = 16, parts.rows = bytes_from_16({0x0102, 0x0103});
    expect_pixels(parts, {{0x0102, 0x0102, 0x0102, 0}, {0x0103, 0x0103, 0x0103, 65535}});
    transparency = {};
    transparency.red = 1, transparency.green = 2, transparency.blue = 3;
    parts.transparency = transparency;
    parts.type = SPNG_COLOR_TYPE_TRUECOLOR, parts.depth = 8;
    parts.rows = bytes_from({1, 2, 3, 1, 2, 4});
    expect_pixels(parts, {{1, 2, 3, 0}, {1, 2, 4, 255}});
}

TEST(Png, Interlaced) {
    // libspng writes the interlace passes; each row below is a row of the whole image.
    PngParts parts{9, 11, 8, SPNG_COLOR_TYPE_GRAYSCALE, true, {}, {}, {}};
    std::vector<Components> expected;
    for (unsigned i = 0; i < 99; ++i) {
        parts.rows.push_back(std::byte(2 * i));
        expected.push_back({2 * i, 2 * i, 2 * i, 255});
    }
    expect_pixels(parts, expected);
    expect_cuts_refused(encode(parts), kEndBytes);
}

template <class T>
std::vector<Rgba<T>> read_by_libspng(Bytes png) {
    spng_ctx* context = spng_ctx_new(0);
    spng_set_png_buffer(context, png.data(), png.size());
    const int format = sizeof(T) == 2 ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8;
    std::size_t size = 0;
    EXPECT_EQ(spng_decoded_image_size(context, format, &size), 0);
    std::vector<Rgba<T>> pixels(size / sizeof(Rgba<T>));
    EXPECT_EQ(spng_decode_image(context, pixels.data(), size, format, SPNG_DECODE_TRNS), 0);
    spng_ctx_free(context);
    return pixels;
}

template <class T>
void expect_libspng_reads_the_same(Bytes png) {
    ASSERT_EQ(read_whole<T>(png).pixels, read_by_libspng<T>(png));
}

struct Kind {
    std::uint8_t type, depth, channels;
};
constexpr Kind kKinds[] = {
    {SPNG_COLOR_TYPE_GRAYSCALE, 1, 1},        {SPNG_COLOR_TYPE_GRAYSCALE, 2, 1},
    {SPNG_COLOR_TYPE_GRAYSCALE, 4, 1},        {SPNG_COLOR_TYPE_GRAYSCALE, 8, 1},
    {SPNG_COLOR_TYPE_GRAYSCALE, 16, 1},       {SPNG_COLOR_TYPE_TRUECOLOR, 8, 3},
    {SPNG_COLOR_TYPE_TRUECOLOR, 16, 3},       {SPNG_COLOR_TYPE_INDEXED, 1, 1},
    {SPNG_COLOR_TYPE_INDEXED, 2, 1},          {SPNG_COLOR_TYPE_INDEXED, 4, 1},
    {SPNG_COLOR_TYPE_INDEXED, 8, 1},          {SPNG_COLOR_TYPE_GRAYSCALE_ALPHA, 8, 2},
    {SPNG_COLOR_TYPE_GRAYSCALE_ALPHA, 16, 2}, {SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, 8, 4},
    {SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, 16, 4},
};

// An image with few values, so that the transparent colour occurs.
PngParts random_picture(const Kind& kind, std::mt19937& random) {
    const auto below = [&](std::uint32_t n) { return std::uint32_t(random() % n); };
    PngParts parts{1 + below(19), 1 + below(19), kind.depth, kind.type, below(2) == 1, {}, {}, {}};
    const std::size_t row = (parts.width * kind.channels * kind.depth + 7u) / 8u;
    for (std::size_t i = 0; i < row * parts.height; ++i)
        parts.rows.push_back(std::byte(below(2) * 0x55u));
    if (kind.type == SPNG_COLOR_TYPE_INDEXED) {
        parts.palette.emplace().n_entries = 1u << kind.depth;
        for (spng_plte_entry& e : parts.palette->entries)
            e = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random()), 255};
    }
    if (kind.channels % 2 == 0 || below(3) == 0) return parts;
    spng_trns& transparent = parts.transparency.emplace();
    const auto value = std::uint16_t(below(2) * 0x5555u & ((1u << kind.depth) - 1));
    transparent.gray = transparent.red = transparent.green = transparent.blue = value;
    transparent.n_type3_entries = 1u << kind.depth;
    for (std::uint8_t& alpha : transparent.type3_alpha)
        alpha = std::uint8_t(random());
    return parts;
}

TEST(Png, AnotherDecoderReadsTheSame) {
    std::mt19937 random(71);
    for (const Kind& kind : kKinds)
        for (int i = 0; i < 40; ++i) {
            const auto png = encode(random_picture(kind, random));
            SCOPED_TRACE(fmt::format("type {}, depth {}, number {}", kind.type, kind.depth, i));
            if (kind.depth == 16)
                expect_libspng_reads_the_same<std::uint16_t>(png);
            else
                expect_libspng_reads_the_same<std::uint8_t>(png);
        }
}

TEST(Png, WrittenIsReadAgain) {
    const Folder folder;
    const Image8 image = gradient(37, 19);
    ASSERT_TRUE(write_png(folder / "a.png", image, true, {}));
    EXPECT_EQ(read_whole<std::uint8_t>(bytes_of_file(folder / "a.png")).pixels, image.pixels);
    ASSERT_TRUE(write_png(folder / "b.png", image, false, {}));
    const Image8 opaque = read_whole<std::uint8_t>(bytes_of_file(folder / "b.png"));
    for (std::size_t i = 0; i < 37 * 19; ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_EQ(opaque.pixels[i][c], image.pixels[i][c]);
        ASSERT_EQ(opaque.pixels[i][3], 255);
    }
}

TEST(Png, MetadataSurvives) {
    const Folder folder;
    const Metadata metadata = {{"Software", "Himalaya 0.1"},
                               {"two words\n", "a\tb\nc"},
                               {"Title", "\xC3\x89t\xC3\xA9"},
                               {std::string(200, 'k'), ""}};
    const auto written = write_png(folder / "a.png", gradient(3, 3), false, metadata);
    ASSERT_TRUE(written) << written.error().line();
    const auto bytes = bytes_of_file(folder / "a.png");
    spng_ctx* context = spng_ctx_new(0);
    spng_set_png_buffer(context, bytes.data(), bytes.size());
    ASSERT_EQ(spng_decode_chunks(context), 0);
    std::uint8_t intent = 0;
    EXPECT_EQ(spng_get_srgb(context, &intent), 0);
    std::uint32_t count = 4;
    spng_text texts[4];
    ASSERT_EQ(spng_get_text(context, texts, &count), 0);
    ASSERT_EQ(count, 4u);
    EXPECT_STREQ(texts[0].keyword, "Software");
    EXPECT_STREQ(texts[0].text, "Himalaya 0.1");
    EXPECT_STREQ(texts[1].keyword, "two_words_");
    EXPECT_STREQ(texts[1].text, "a b\nc");
    EXPECT_EQ(texts[2].type, SPNG_ITXT);
    EXPECT_STREQ(texts[2].text, "\xC3\x89t\xC3\xA9");
    EXPECT_STREQ(texts[3].text, " ");
    EXPECT_EQ(std::string(texts[3].keyword), std::string(79, 'k'));
    spng_ctx_free(context);
}

// The standard allows a still image that is not one of the animation's frames.
TEST(Png, AnimationsGiveTheirStillPicture) {
    constexpr std::ptrdiff_t kHeaderEnd = 33, kEnd = 12;  // signature and IHDR; IEND
    PngParts parts{1, 1, 8, SPNG_COLOR_TYPE_TRUECOLOR, false, {}, {}, bytes_from({200, 100, 50})};
    const auto frame = encode(parts);
    parts.rows = bytes_from({10, 20, 30});
    auto animated = encode(parts);

    std::vector<std::byte> control;
    for (const std::uint32_t value : {0u, 1u, 1u, 0u, 0u})  // sequence number, size, offset
        append_number(control, value);
    for (const std::uint32_t value : {0x00010001u, 0u})  // delay of 1 s; no blending
        append_number(control, value);
    control.resize(26);
    std::vector<std::byte> data = bytes_from({0, 0, 0, 1});
    data.insert(data.end(), frame.begin() + kHeaderEnd + 8, frame.end() - kEnd - 4);
    const auto insert = [&](std::ptrdiff_t before_end, const std::vector<std::byte>& chunk) {
        animated.insert(animated.end() - before_end, chunk.begin(), chunk.end());
    };
    insert(kEnd, make_chunk("fcTL", control));
    insert(kEnd, make_chunk("fdAT", data));
    insert(std::ptrdiff_t(animated.size()) - kHeaderEnd,
           make_chunk("acTL", bytes_from({0, 0, 0, 1, 0, 0, 0, 0})));
    const Image8 image = read_whole<std::uint8_t>(animated);
    EXPECT_EQ(image.pixels[0][0], 10);
    EXPECT_EQ(image.pixels[0][1], 20);
    EXPECT_EQ(image.pixels[0][2], 30);
    EXPECT_EQ(image.pixels[0][3], 255);
}

}  // namespace
}  // namespace hm
