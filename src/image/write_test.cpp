// What the three writers have in common; each format's own test reads back what it wrote.
#include "image/write.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

TEST(WriteImage, RefusalNamesTheFile) {
    const Folder folder;
    const Image display = make_image(2, 2, PixelFormat::rgba8);
    const Image light = make_image(2, 2, PixelFormat::rgba32f);
    for (const auto& path : {folder / "missing/a", folder / ""}) {
        for (const Result<void>& written :
             {write_png(path, display, false, {}), write_exr(path, light, false, {}),
              write_hdr(path, light)}) {
            ASSERT_FALSE(written);
            EXPECT_EQ(written.error().kind, ErrorKind::unwritable);
            EXPECT_EQ(written.error().file, path.string());
        }
    }
}

TEST(WriteImage, WrongFormatIsABug) {
    const Folder folder;
    const Image display = make_image(2, 2, PixelFormat::rgba8);
    EXPECT_THROW((void)write_exr(folder / "a", display, false, {}), CheckFailure);
    Image torn = display;
    torn.pixels.pop_back();
    EXPECT_THROW((void)write_png(folder / "a", torn, false, {}), CheckFailure);
}

}  // namespace
}  // namespace hm
