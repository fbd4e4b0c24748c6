#include "base/check.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace hm {
namespace {

TEST(Check, PassesSilently) {
    int evaluated = 0;
    HM_CHECK(++evaluated == 1, "evaluated = {}", evaluated);
    EXPECT_EQ(evaluated, 1);
}

TEST(Check, ThrowsLocationConditionAndValues) {
    const int i = 3, n = 2;
    try {
        HM_CHECK(i < n, "i = {}, n = {}", i, n);
        FAIL() << "nothing was thrown";
    } catch (const CheckFailure& failure) {
        const std::regex expected(
            ".*check_test.cpp:[0-9]+: check failed: i < n \\(i = 3, n = 2\\)");
        EXPECT_TRUE(std::regex_match(failure.what(), expected)) << failure.what();
    }
}

}  // namespace
}  // namespace hm
