#include "denoise/mirror.h"

#include <gtest/gtest.h>

namespace hm {
namespace {

FloatImage numbered(std::uint32_t width, std::uint32_t height) {
    FloatImage image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {float(i), 0, 0, 1};
    return image;
}

TEST(Mirror, ContinuesByMirrorImages) {
    const FloatImage row = mirrored(numbered(3, 1), 9);
    ASSERT_EQ(row.width, 9u);
    ASSERT_EQ(row.height, 9u);
    const float expected[] = {2, 1, 0, 0, 1, 2, 2, 1, 0};
    for (std::size_t y = 0; y < 9; ++y)
        for (std::size_t x = 0; x < 9; ++x)
            EXPECT_EQ(row.pixels[9 * y + x][0], expected[x]) << x << ", " << y;
}

TEST(Mirror, MiddleIsThePicture) {
    for (const auto& [width, height] : {std::pair(1u, 1u), {3u, 7u}, {20u, 2u}, {5u, 5u}}) {
        const FloatImage image = numbered(width, height);
        const FloatImage larger = mirrored(image, 8);
        EXPECT_EQ(larger.width, std::max(width, 8u));
        EXPECT_EQ(middle(larger, width, height).pixels, image.pixels);
    }
}

}  // namespace
}  // namespace hm
