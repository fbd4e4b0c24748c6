#include "image/picture_file.h"

#include <gtest/gtest.h>

#include "image/test_images.h"
#include "image/write.h"

namespace hm {
namespace {

using namespace testing_images;

TEST(PictureFile, APngLiesOverBlack) {
    const Folder folder;
    Image8 image(1, 1);
    image.pixels[0][0] = 255;
    image.pixels[0][1] = 51;
    image.pixels[0][3] = 51;
    ASSERT_TRUE(write_png(folder / "a.png", image, true, {}));
    const auto file = read_picture_file(folder / "a.png");
    ASSERT_TRUE(file) << file.error().line();
    EXPECT_TRUE(file->encoded);
    ASSERT_EQ(file->picture.layers.size(), 1u);
    const Layer& layer = file->picture.layers[0];
    EXPECT_FLOAT_EQ(layer.find("R")->values[0], 0.2f);
    EXPECT_FLOAT_EQ(layer.find("G")->values[0], 0.04f);
    EXPECT_FLOAT_EQ(layer.find("A")->values[0], 0.2f);
}

TEST(PictureFile, RadianceIsLinear) {
    const Folder folder;
    FloatImage image(3, 2);
    image.pixels[4][1] = 8.0f;
    ASSERT_TRUE(write_exr(folder / "a.exr", image, false, {}));
    ASSERT_TRUE(write_hdr(folder / "a.hdr", image));
    for (const char* name : {"a.exr", "a.hdr"}) {
        const auto file = read_picture_file(folder / name);
        ASSERT_TRUE(file) << file.error().line();
        EXPECT_FALSE(file->encoded);
        EXPECT_EQ(file->picture.data, (PictureWindow{0, 0, 3, 2}));
        ASSERT_EQ(file->picture.layers.size(), 1u);
        EXPECT_EQ(file->picture.layers[0].find("G")->values[4], 8.0f);
    }
}

TEST(PictureFile, ErrorsNameTheFile) {
    const Folder folder;
    const auto missing = read_picture_file(folder / "none.exr");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::unreadable);
    EXPECT_NE(missing.error().line().find("none.exr"), std::string::npos);
}

}  // namespace
}  // namespace hm
