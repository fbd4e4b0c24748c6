// The number of threads in OpenEXR's pool, counted by the system.
#include "image/exr_threads.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "image/codecs.h"

namespace hm {
namespace {

std::ptrdiff_t threads() {
    namespace fs = std::filesystem;
    return std::distance(fs::directory_iterator("/proc/self/task"), fs::directory_iterator());
}

TEST(ExrThreads, TheLibraryStartsNone) {
    if (!std::filesystem::exists("/proc/self/task")) GTEST_SKIP() << "threads are counted in /proc";
    const std::ptrdiff_t before = threads();
    const FloatImage image(256, 256);
    const auto one = encode_exr(image, true, {});
    ASSERT_TRUE(one);
    EXPECT_EQ(threads(), before);

    set_exr_threads(3);
    EXPECT_EQ(threads(), before + 3);
    const auto three = encode_exr(image, true, {});
    ASSERT_TRUE(three);
    EXPECT_EQ(*three, *one);

    set_exr_threads(1);
    EXPECT_EQ(threads(), before);
}

}  // namespace
}  // namespace hm
