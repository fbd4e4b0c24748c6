// Properties of the generated tables: the blue noise is a permutation without low frequencies; the
// Sobol directions are Joe and Kuo's, each dimension is stratified and the first two form a
// (0,2)-sequence.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace hm {
namespace {

constexpr std::size_t kSide = 128;
constexpr std::size_t kPixels = kSide * kSide;
constexpr std::uint16_t kBlueNoise[] = {
#include "shading/tables/blue_noise_128.inl"
};
static_assert(std::size(kBlueNoise) == kPixels);

constexpr std::size_t kDimensions = 128;
constexpr std::size_t kBits = 32;
constexpr std::uint32_t kDirections[] = {
#include "shading/tables/sobol_directions.inl"
};
static_assert(std::size(kDirections) == kDimensions * kBits);

std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
    std::uint32_t x = 0;
    for (std::size_t i = 0; i < kBits; ++i)
        if (index >> i & 1u) x ^= kDirections[dimension * kBits + i];
    return x;
}

// Power at frequency (kx, ky) relative to white noise of the same variance, whose expectation is 1.
double relative_power(int kx, int ky) {
    const double mean = double(kPixels - 1) / 2;
    const double variance = (double(kPixels) * double(kPixels) - 1) / 12;
    double re = 0, im = 0;
    for (std::size_t y = 0; y < kSide; ++y)
        for (std::size_t x = 0; x < kSide; ++x) {
            const double turns = (double(x) * kx + double(y) * ky) / double(kSide);
            const double value = kBlueNoise[y * kSide + x] - mean;
            re += value * std::cos(2 * std::numbers::pi * turns);
            im += value * std::sin(2 * std::numbers::pi * turns);
        }
    return (re * re + im * im) / (double(kPixels) * variance);
}

TEST(BlueNoise, RanksArePermutation) {
    std::vector<int> seen(kPixels, 0);
    for (const std::uint16_t rank : kBlueNoise) {
        ASSERT_LT(rank, kPixels);
        EXPECT_EQ(seen[rank]++, 0) << "rank " << rank;
    }
}

// Measured: at most 3e-4 at any single frequency; a shuffled array has 1.
TEST(BlueNoise, LowFrequenciesAreEmpty) {
    for (int ky = 0; ky < 8; ++ky)
        for (int kx = -7; kx < 8; ++kx) {
            if ((kx == 0 && ky == 0) || kx * kx + ky * ky >= 64) continue;
            EXPECT_LT(relative_power(kx, ky), 0.01) << kx << ", " << ky;
        }
}

// Thresholded arrays must be evenly distributed too: no two of the first 256 ranks (mean distance
// about 8 pixels) are neighbours.
TEST(BlueNoise, FirstRanksKeepApart) {
    std::vector<std::array<int, 2>> points;
    for (std::size_t i = 0; i < kPixels; ++i)
        if (kBlueNoise[i] < 256) points.push_back({int(i % kSide), int(i / kSide)});
    const auto wrapped = [](int a, int b) {
        const int d = std::abs(a - b);
        return std::min(d, int(kSide) - d);
    };
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const int dx = wrapped(points[i][0], points[j][0]);
            const int dy = wrapped(points[i][1], points[j][1]);
            EXPECT_GE(dx * dx + dy * dy, 16);
        }
}

// Rows of the published table new-joe-kuo-6, expanded by the recurrence of Joe and Kuo (2008), (3).
TEST(Sobol, FirstDimensionsAreJoeAndKuos) {
    struct Row {
        std::uint32_t degree, a;
        std::vector<std::uint32_t> m;
    };
    const std::vector<Row> rows = {{1, 0, {1}},
                                   {2, 1, {1, 3}},
                                   {3, 1, {1, 3, 1}},
                                   {3, 2, {1, 1, 1}},
                                   {4, 1, {1, 1, 3, 3}},
                                   {4, 4, {1, 3, 5, 13}},
                                   {5, 2, {1, 1, 5, 5, 17}},
                                   {5, 4, {1, 1, 5, 5, 5}},
                                   {5, 7, {1, 1, 7, 11, 19}}};
    for (std::size_t i = 0; i < kBits; ++i)
        EXPECT_EQ(kDirections[i], 1u << (31 - i));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const auto& [degree, a, initial] = rows[r];
        std::vector<std::uint32_t> m = initial;
        for (std::size_t k = degree; k < kBits; ++k) {
            std::uint32_t next = m[k - degree] ^ (m[k - degree] << degree);
            for (std::uint32_t j = 1; j < degree; ++j)
                if (a >> (degree - 1 - j) & 1u) next ^= m[k - j] << j;
            m.push_back(next);
        }
        for (std::size_t i = 0; i < kBits; ++i)
            EXPECT_EQ(kDirections[(r + 1) * kBits + i], m[i] << (31 - i))
                << "dimension " << r + 1 << " bit " << i;
    }
}

// One point in each of 2^k equal intervals, for every dimension and several k, also in later
// blocks.
TEST(Sobol, EveryDimensionIsStratified) {
    for (std::size_t d = 0; d < kDimensions; ++d)
        for (const std::uint32_t k : {1u, 4u, 8u, 11u})
            for (const std::uint32_t block : {0u, 5u}) {
                const std::uint32_t n = 1u << k;
                std::vector<int> seen(n, 0);
                for (std::uint32_t i = 0; i < n; ++i)
                    ++seen[sobol(block * n + i, d) >> (32 - k)];
                for (std::uint32_t i = 0; i < n; ++i)
                    ASSERT_EQ(seen[i], 1)
                        << "dimension " << d << ", 2^" << k << ", block " << block;
            }
}

// Every elementary rectangle 2^-a x 2^-b, a + b = k, holds one point of each block of 2^k.
TEST(Sobol, FirstTwoDimensionsAreZeroTwoSequence) {
    for (std::uint32_t k = 1; k <= 12; ++k)
        for (std::uint32_t a = 0; a <= k; ++a)
            for (const std::uint32_t block : {0u, 3u}) {
                const std::uint32_t n = 1u << k;
                const std::uint32_t b = k - a;
                std::vector<int> seen(n, 0);
                for (std::uint32_t i = 0; i < n; ++i) {
                    const std::uint64_t x = sobol(block * n + i, 0);
                    const std::uint64_t y = sobol(block * n + i, 1);
                    ++seen[(x >> (32 - a)) << b | (y >> (32 - b))];
                }
                for (std::uint32_t i = 0; i < n; ++i)
                    ASSERT_EQ(seen[i], 1)
                        << "2^" << k << ", " << a << " bits of x, block " << block;
            }
}

}  // namespace
}  // namespace hm
