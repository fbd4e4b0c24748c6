// Which format may be used for what, and reading from several threads at once.
#include "image/read.h"

#include <gtest/gtest.h>

#include <thread>

#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

TEST(ReadImage, SignatureDecides) {
    const auto png = encode_png(make_image(2, 2, PixelFormat::rgba8), true, {});
    const auto exr = encode_exr(make_image(2, 2, PixelFormat::rgba32f), true, {});
    const auto hdr = encode_hdr(make_image(2, 2, PixelFormat::rgba32f));
    ASSERT_TRUE(png && exr);
    EXPECT_TRUE(read_texture_image(*png, "wrong.exr"));
    EXPECT_FALSE(read_texture_image(*exr, "a.png"));
    EXPECT_FALSE(read_texture_image(hdr, "a.png"));
    EXPECT_FALSE(read_environment_image(*png, "a.exr"));
    EXPECT_TRUE(read_environment_image(*exr, "a"));
    EXPECT_TRUE(read_environment_image(hdr, "a"));
    const std::vector<std::byte> other(64, std::byte(7));
    for (const auto read : {read_texture_image, read_environment_image, read_image}) {
        ASSERT_FALSE(read(other, "odd"));
        EXPECT_EQ(read(other, "odd").error().line(), "odd: not a picture of a known format");
        EXPECT_EQ(read({}, "none").error().line(), "none: the picture is empty");
    }
}

TEST(ReadImage, FromManyThreads) {
    Image picture = make_image(64, 64, PixelFormat::rgba32f);
    for (std::size_t i = 0; i < 64 * 64 * 4; ++i)
        set_component(picture, i / 4, i % 4, float(i % 4 == 3));
    const auto exr = encode_exr(picture, true, {});
    const auto hdr = encode_hdr(picture);
    const auto png = encode_png(make_image(64, 64, PixelFormat::rgba8), true, {});
    ASSERT_TRUE(exr && png);
    std::vector<int> right(4, 0);
    std::vector<std::thread> threads;
    for (int& count : right)
        threads.emplace_back([&] {
            for (int i = 0; i < 20; ++i) {
                const auto a = read_environment_image(*exr, "exr");
                const auto b = read_environment_image(hdr, "hdr");
                const auto c = read_texture_image(*png, "png");
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
