// Common behaviour of the three writers; round trips are in each format's own test.
#include "image/write.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "image/test_images.h"

namespace hm {
namespace {

using namespace testing_images;

TEST(WriteImage, RefusalNamesTheFile) {
    const Folder folder;
    const Image8 display(2, 2);
    const FloatImage light(2, 2);
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

TEST(WriteImage, MissingPixelsAreABug) {
    const Folder folder;
    Image8 torn(2, 2);
    torn.pixels.pop_back();
    EXPECT_THROW((void)write_png(folder / "a", torn, false, {}), CheckFailure);
}

}  // namespace
}  // namespace hm
