#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace hm {
namespace {

TEST(Error, LineLeavesOutWhatIsEmpty) {
    EXPECT_EQ((Error{ErrorKind::invalid, "a.gltf", "/meshes/0", "no"}.line()),
              "a.gltf: /meshes/0: no");
    EXPECT_EQ((Error{ErrorKind::invalid, "a.gltf", "", "no"}.line()), "a.gltf: no");
    EXPECT_EQ((Error{ErrorKind::invalid_argument, "", "", "no"}.line()), "no");
}

TEST(Error, LineIsOneLine) {
    EXPECT_EQ((Error{ErrorKind::invalid, "a\n.gltf", "/\x1B", "b\rc"}.line()),
              "a\\x0A.gltf: /\\x1B: b\\x0Dc");
}

Result<std::unique_ptr<int>> make(bool good) {
    if (!good) return fail(ErrorKind::unsupported, "f", "p", "m");
    return std::make_unique<int>(7);
}

Result<void> check(bool good) {
    HM_TRY(make(good));
    return {};
}

Result<int> sum(bool good) {
    HM_TRY_ASSIGN(const std::unique_ptr<int> a, make(true));
    HM_TRY_ASSIGN(const std::unique_ptr<int> b, make(good));
    return *a + *b;
}

TEST(Result, TryPassesValuesAndErrorsOn) {
    EXPECT_TRUE(check(true).has_value());
    ASSERT_TRUE(sum(true).has_value());
    EXPECT_EQ(*sum(true), 14);
    ASSERT_FALSE(check(false).has_value());
    ASSERT_FALSE(sum(false).has_value());
    EXPECT_EQ(sum(false).error().kind, ErrorKind::unsupported);
    EXPECT_EQ(sum(false).error().line(), "f: p: m");
}

}  // namespace
}  // namespace hm
