// Alias tables represent exactly the distribution they were built from.
#include "scene/alias_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/statistics.h"

namespace hm {
namespace {

// The probability of each entry for lookups with 32-bit integers.
std::vector<double> recover(const std::vector<AliasEntry>& table) {
    std::vector<double> p(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        double own = double(table[i].threshold) / 4294967296.0;
        p[i] += own / double(table.size());
        p[table[i].alias] += (1 - own) / double(table.size());
    }
    return p;
}

void expect_exact(const std::vector<float>& weights) {
    const std::vector<AliasEntry> table = build_alias_table(weights);
    const std::vector<double> p = recover(table);
    double sum = 0;
    for (float w : weights)
        sum += double(w);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        double exact = double(weights[i]) / sum;
        // Tolerance: thresholds are quantized to 2^-32 of a slot; the build's sums are rounded.
        EXPECT_NEAR(p[i], exact, 1e-6 * exact + 3e-10) << i << " of " << weights.size();
        EXPECT_FLOAT_EQ(table[i].pdf_self, float(exact));
        EXPECT_EQ(table[i].pdf_alias, table[table[i].alias].pdf_self);
        if (weights[i] == 0) {
            EXPECT_EQ(p[i], 0.0) << i;
            EXPECT_EQ(table[i].threshold, 0u) << i;
        }
    }
}

TEST(AliasTable, HoldsItsWeights) {
    test::Random random(71);
    for (std::size_t n : {1u, 2u, 3u, 7u, 64u, 1000u, 32768u}) {
        std::vector<float> even(n, 0.3f), uneven(n), wide(n), sparse(n, 0.0f);
        for (std::size_t i = 0; i < n; ++i) {
            uneven[i] = random.unit() + 0.01f;
            wide[i] = std::exp2(random.between(-40, 40));
            sparse[i] = random.unit() < 0.1f ? random.unit() + 0.1f : 0.0f;
        }
        sparse[n / 2] = 5;
        expect_exact(even);
        expect_exact(uneven);
        expect_exact(wide);
        expect_exact(sparse);
    }
    expect_exact({0, 0, 1});
    expect_exact({1e-30f, 1e30f});
    expect_exact({0, 1e-38f, 0});
}

TEST(AliasTable, OfNothingHasNoDensity) {
    EXPECT_TRUE(build_alias_table({}).empty());
    const std::vector<float> zeros(5, 0.0f);
    for (const AliasEntry& e : build_alias_table(zeros)) {
        EXPECT_EQ(e.pdf_self, 0.0f);
        EXPECT_EQ(e.pdf_alias, 0.0f);
        EXPECT_LT(e.alias, 5u);
    }
}

TEST(AliasTable, DrawsFollowTheWeights) {
    test::Random random(72);
    std::vector<float> weights(100);
    for (float& w : weights)
        w = random.unit() < 0.2f ? 0.0f : random.unit();
    const std::vector<AliasEntry> table = build_alias_table(weights);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<double> shares;
    for (float w : weights)
        shares.push_back(double(w) / sum);
    test::Histogram histogram(weights.size());
    for (int i = 0; i < 200000; ++i) {
        std::uint32_t slot = mul_high(random.bits(), 100), coin = random.bits();
        std::uint32_t drawn = coin < table[slot].threshold ? slot : table[slot].alias;
        ASSERT_GT(weights[drawn], 0.0f);
        histogram.add(drawn);
    }
    EXPECT_GT(histogram.test(shares).p_value, test::single_level());
}

}  // namespace
}  // namespace hm
