#include "base/check.h"

#include <gtest/gtest.h>

namespace hm {
namespace {

TEST(Check, PassesInSilence) {
    int evaluated = 0;
    HM_CHECK(++evaluated == 1, "evaluated = {}", evaluated);
    EXPECT_EQ(evaluated, 1);
}

TEST(CheckDeathTest, PrintsPlaceConditionAndValues) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const int i = 3, n = 2;
    EXPECT_DEATH(HM_CHECK(i < n, "i = {}, n = {}", i, n),
                 "check_test.cpp:[0-9]+: check failed: i < n \\(i = 3, n = 2\\)");
}

}  // namespace
}  // namespace hm
