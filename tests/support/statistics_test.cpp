// The statistical functions against published values, and that a wrong pdf is detected.
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hm::test {
namespace {

TEST(Statistics, TailsOfKnownDistributions) {
    // Chi-square 5 % critical values: 3.841 for 1, 18.307 for 10, 124.342 for 100 degrees of
    // freedom.
    EXPECT_NEAR(gamma_q(0.5, 0.5 * 3.841459), 0.05, 1e-6);
    EXPECT_NEAR(gamma_q(5, 0.5 * 18.307038), 0.05, 1e-6);
    EXPECT_NEAR(gamma_q(50, 0.5 * 124.342113), 0.05, 1e-6);
    EXPECT_NEAR(gamma_q(1, 20), std::exp(-20.0), 1e-15);
    // Student's t, two-sided: 5 % beyond 2.131450 for 15 and 12.7062 for 1 degree of freedom; 0.1 %
    // beyond 4.0728 for 15.
    EXPECT_NEAR(student_tail(2.131450, 15), 0.05, 1e-6);
    EXPECT_NEAR(student_tail(12.706205, 1), 0.05, 1e-6);
    EXPECT_NEAR(student_tail(4.072765, 15), 0.001, 1e-7);
    EXPECT_NEAR(student_tail(0.01, 15), 0.992153, 1e-5);
    EXPECT_NEAR(normal_tail(1.959964), 0.05, 1e-6);
    EXPECT_NEAR(sidak_level(0.05, 10), 0.0051162, 1e-6);
}

TEST(Statistics, ChiSquareSeesOnePercentAndNotChance) {
    Random random(1);
    Histogram fair(20), loaded(20);
    for (int i = 0; i < 400000; ++i) {
        fair.add(std::size_t(random.unit() * 20));
        float x = random.unit();
        loaded.add(std::size_t((x < 0.5f ? 1.02f * x : x) * 20));
    }
    const std::vector<double> even(20, 0.05);
    EXPECT_GT(fair.test(even).p_value, 0.001);
    EXPECT_LT(loaded.test(even).p_value, single_level());
}

TEST(Statistics, SmallBinsAreMergedAndMissingMassIsABin) {
    Histogram h(4);
    for (int i = 0; i < 96; ++i)
        h.add(0);
    h.add(1);
    for (int i = 0; i < 3; ++i)
        h.add_rest();
    const std::vector<double> shares = {0.9, 0.01, 0.01, 0.0};
    ChiSquare c = h.test(shares);
    // Bins 1 and 2 expect two and merge with the missing eight: 96 for 90 expected, 4 for 10.
    EXPECT_EQ(c.degrees, 1);
    EXPECT_NEAR(c.statistic, 36.0 / 90 + 36.0 / 10, 1e-9);
}

}  // namespace
}  // namespace hm::test
