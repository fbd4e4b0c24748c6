// Allowed formats of textures and environments, and reading from several threads.
#include "image/read.h"

#include <gtest/gtest.h>

#include <thread>

#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

TEST(ReadImage, SignatureDecides) {
    const auto png = encode_png(Image8(2, 2), true, {});
    const auto exr = encode_exr(FloatImage(2, 2), true, {});
    const auto hdr = encode_hdr(FloatImage(2, 2));
    ASSERT_TRUE(png && exr);
    ReadWarnings warnings;
    EXPECT_TRUE(read_texture_image(*png, "wrong.exr", warnings));
    EXPECT_FALSE(read_texture_image(*exr, "a.png", warnings));
    EXPECT_FALSE(read_texture_image(hdr, "a.png", warnings));
    EXPECT_FALSE(read_environment_image(*png, "a.exr", warnings));
    EXPECT_TRUE(read_environment_image(*exr, "a", warnings));
    EXPECT_TRUE(read_environment_image(hdr, "a", warnings));
    const std::vector<std::byte> other(64, std::byte(7));
    const auto expect_refusal = [&](const auto& read) {
        ASSERT_FALSE(read(other, "odd"));
        EXPECT_EQ(read(other, "odd").error().line(), "odd: unknown image format");
        EXPECT_EQ(read(Bytes(), "none").error().line(), "none: the image is empty");
    };
    expect_refusal(
        [&](Bytes b, const char* name) { return read_texture_image(b, name, warnings); });
    expect_refusal(
        [&](Bytes b, const char* name) { return read_environment_image(b, name, warnings); });
    expect_refusal(read_image);
}

TEST(ReadImage, FromManyThreads) {
    FloatImage picture(64, 64);
    for (std::size_t i = 0; i < 64 * 64 * 4; ++i)
        picture.pixels[i / 4][i % 4] = float(i % 4 == 3);
    const auto exr = encode_exr(picture, true, {});
    const auto hdr = encode_hdr(picture);
    const auto png = encode_png(Image8(64, 64), true, {});
    ASSERT_TRUE(exr && png);
    std::vector<int> right(4, 0);
    std::vector<std::thread> threads;
    for (int& count : right)
        threads.emplace_back([&] {
            ReadWarnings warnings;
            for (int i = 0; i < 20; ++i) {
                const auto a = read_environment_image(*exr, "exr", warnings);
                const auto b = read_environment_image(hdr, "hdr", warnings);
                const auto c = read_texture_image(*png, "png", warnings);
                if (a && b && c && a->pixels == picture.pixels && b->pixels == picture.pixels)
                    ++count;
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(right, std::vector<int>(4, 20));
}

}  // namespace
}  // namespace hm
