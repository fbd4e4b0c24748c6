// The samplers: stratified where they promise it, independent where they promise that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/hosts.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::SamplerHost;

constexpr uint kGroups[] = {0, 4, 8, 12, 60, 124};

uint number(const uvec4& x, uint k) {
    return x[std::size_t(k)];
}

TEST(Sampler, SobolBeginsAsPublished) {
    SamplerHost host(kSamplerSobolOwen, 0);
    const uint half = 0x80000000u, quarter = 0x40000000u;
    // Dimension 0 is van der Corput; dimension 1: 0, 1/2, 3/4, 1/4, ...
    const uint first[] = {0, half, quarter, half + quarter};
    const uint second[] = {0, half, half + quarter, quarter};
    for (uint i = 0; i < 4; ++i) {
        EXPECT_EQ(host.sobol_number(0, i), first[i]);
        EXPECT_EQ(host.sobol_number(1, i), second[i]);
    }
    for (uint d = 0; d < 128; ++d) {
        EXPECT_EQ(host.sobol_number(d, 0), 0u);
        EXPECT_EQ(host.sobol_number(d, 1), half);
    }
}

TEST(Sampler, OwenStratifiesEveryDimensionInEveryBlock) {
    SamplerHost host(kSamplerSobolOwen, 7);
    for (uint group : kGroups)
        for (uint log2_size = 1; log2_size <= 9; ++log2_size)
            for (uint block = 0; block < 5; ++block) {
                std::set<uint> strata[4];
                for (uint i = 0; i < 1u << log2_size; ++i) {
                    uvec4 x = host.numbers(3, 5, (block << log2_size) + i, group);
                    for (uint k = 0; k < 4; ++k)
                        strata[k].insert(number(x, k) >> (32 - log2_size));
                }
                for (const std::set<uint>& s : strata)
                    EXPECT_EQ(s.size(), 1u << log2_size) << group << " " << log2_size;
            }
}

// The t of a (t, k, 2)-net: the smallest for which every elementary interval of 2^t points' area
// holds just those. 0 is best.
template <class Points>
int net_quality(int k, Points&& points) {
    std::vector<uvec2> p;
    for (uint i = 0; i < 1u << k; ++i)
        p.push_back(points(i));
    for (int t = 0; t <= k; ++t) {
        bool good = true;
        for (int a = 0; a <= k - t && good; ++a) {
            int b = k - t - a;
            std::vector<int> counts(std::size_t(1) << (k - t));
            for (uvec2 q : p) {
                std::size_t i = a == 0 ? 0 : q.x >> (32 - a);
                std::size_t j = b == 0 ? 0 : q.y >> (32 - b);
                ++counts[(i << b) + j];
            }
            good = std::ranges::all_of(counts, [&](int c) { return c == 1 << t; });
        }
        if (good) return t;
    }
    return k + 1;
}

TEST(Sampler, OwenKeepsTheElementaryIntervalsOfSobol) {
    SamplerHost host(kSamplerSobolOwen, 7);
    for (uint a = 0; a < 4; ++a)
        for (uint b = a + 1; b < 4; ++b)
            for (int k : {4, 6, 8, 10}) {
                int plain = net_quality(k, [&](uint i) {
                    return uvec2(host.sobol_number(a, i), host.sobol_number(b, i));
                });
                EXPECT_TRUE(plain == 0 || a + b > 1);
                for (uint group : kGroups)
                    for (uint block : {0u, 3u}) {
                        int scrambled = net_quality(k, [&](uint i) {
                            uvec4 x = host.numbers(90, 17, (block << k) + i, group);
                            return uvec2(number(x, a), number(x, b));
                        });
                        // Blocks but the first are shifted nets, no better than t allows.
                        EXPECT_LE(scrambled, std::max(plain, a == 0 && b == 1 ? 0 : 2))
                            << a << b << " of group " << group << ", 2^" << k << " points";
                    }
            }
}

TEST(Sampler, BlueNoiseRotatesSobol) {
    SamplerHost host(kSamplerSobolBlueNoise, 3);
    for (uint group : kGroups)
        for (uint k = 0; k < 4; ++k) {
            uint offset = number(host.numbers(40, 50, 0, group), k);
            for (uint i : {1u, 2u, 77u, 4095u, 1000000u})
                EXPECT_EQ(number(host.numbers(40, 50, i, group), k) - offset,
                          host.sobol_number(group + k, i));
            // The tile holds each of its 2^14 offsets once, evenly spread.
            std::set<uint> offsets;
            for (uint y = 0; y < 128; ++y)
                for (uint x = 0; x < 128; ++x)
                    offsets.insert(number(host.numbers(x, y, 0, group), k) >> 18);
            EXPECT_EQ(offsets.size(), 128u * 128u);
        }
}

TEST(Sampler, DimensionsPast127AreIndependentForAll) {
    SamplerHost independent(kSamplerIndependent, 9), owen(kSamplerSobolOwen, 9),
        blue(kSamplerSobolBlueNoise, 9);
    for (uint d : {128u, 132u, 1000u}) {
        EXPECT_EQ(owen.numbers(1, 2, 3, d), independent.numbers(1, 2, 3, d));
        EXPECT_EQ(blue.numbers(1, 2, 3, d), independent.numbers(1, 2, 3, d));
    }
    EXPECT_NE(owen.numbers(1, 2, 3, 124), independent.numbers(1, 2, 3, 124));
    EXPECT_NE(blue.numbers(1, 2, 3, 124), independent.numbers(1, 2, 3, 124));
}

TEST(Sampler, SeedsAndPixelsGiveDifferentNumbers) {
    for (uint kind : {kSamplerIndependent, kSamplerSobolBlueNoise, kSamplerSobolOwen})
        for (uint d : {0u, 8u, 124u, 128u}) {
            SamplerHost one(kind, 1), two(kind, 2);
            for (uint k = 0; k < 4; ++k) {
                EXPECT_NE(number(one.numbers(4, 4, 5, d), k), number(two.numbers(4, 4, 5, d), k));
                EXPECT_NE(number(one.numbers(4, 4, 5, d), k), number(one.numbers(5, 4, 5, d), k));
                EXPECT_NE(number(one.numbers(4, 4, 5, d), k), number(one.numbers(4, 5, 5, d), k));
            }
        }
}

// A 32 x 32 histogram of five bits each of two numbers: the highest, and the lowest that floats
// keep. (The lowest eight of PCG are weak and choose nothing.)
template <class Pair>
double independence_p(int count, uint shift, Pair&& pair) {
    test::Histogram histogram(32 * 32);
    for (int i = 0; i < count; ++i) {
        uvec2 x = pair(uint(i));
        histogram.add(((x.x >> shift) & 31) * 32 + ((x.y >> shift) & 31));
    }
    return histogram.test(std::vector(32 * 32, 1.0 / 1024)).p_value;
}

TEST(Sampler, IndependentNumbersAreUniformAndUncorrelated) {
    constexpr int kCount = 1 << 16;
    SamplerHost host(kSamplerIndependent, 12), other(kSamplerIndependent, 13);
    for (uint shift : {27u, 17u, 8u}) {
        const double level = test::single_level();
        SCOPED_TRACE(testing::Message() << "bits from " << shift);
        for (uint d : {0u, 8u, 12u, 132u})
            for (uint k = 0; k < 4; ++k) {
                auto at = [&](SamplerHost& h, uint x, uint y, uint i, uint dim, uint c) {
                    return number(h.numbers(x, y, i, dim), c);
                };
                uint next = (k + 1) % 4;
                auto p = [&](auto&& second) {
                    return independence_p(kCount, shift, [&](uint i) {
                        return uvec2(at(host, 6, 6, i, d, k), second(i));
                    });
                };
                EXPECT_GT(p([&](uint i) { return at(host, 6, 6, i, d, next); }), level);
                EXPECT_GT(p([&](uint i) { return at(host, 6, 6, i, d + 4, k); }), level);
                EXPECT_GT(p([&](uint i) { return at(host, 6, 6, i + 1, d, k); }), level);
                EXPECT_GT(p([&](uint i) { return at(host, 7, 6, i, d, k); }), level);
                EXPECT_GT(p([&](uint i) { return at(host, 6, 7, i, d, k); }), level);
                EXPECT_GT(p([&](uint i) { return at(other, 6, 6, i, d, k); }), level);
                EXPECT_GT(independence_p(kCount, shift,
                                         [&](uint i) {
                                             return uvec2(at(host, i & 255, i >> 8, 0, d, k),
                                                          at(host, i & 255, i >> 8, 1, d, k));
                                         }),
                          level);
            }
    }
}

// Root mean square error over pixels of the mean of a smooth function with a known integral: the
// product of exp(-x) over the first `axes` of a group's numbers.
double integration_error(uint kind, uint count, uint axes) {
    const double exact = std::pow(1 - std::exp(-1.0), double(axes));
    double sum = 0;
    constexpr uint kPixels = 64;
    for (uint pixel = 0; pixel < kPixels; ++pixel) {
        SamplerHost host(kind, 5);
        double mean = 0;
        for (uint i = 0; i < count; ++i) {
            uvec4 x = host.numbers(pixel, 31, i, 8);
            double value = 1;
            for (uint k = 0; k < axes; ++k)
                value *= std::exp(-double(number(x, k)) * 0x1p-32);
            mean += value / count;
        }
        sum += (mean - exact) * (mean - exact) / kPixels;
    }
    return std::sqrt(sum);
}

TEST(Sampler, SobolConvergesFasterThanRandom) {
    for (uint axes : {2u, 4u}) {
        double random_64 = integration_error(kSamplerIndependent, 64, axes);
        double random_1024 = integration_error(kSamplerIndependent, 1024, axes);
        // Sixteen times the samples: a fourth of the error, within its own noise (64 pixels).
        EXPECT_NEAR(random_64 / random_1024, 4, 1.5);
        for (uint kind : {kSamplerSobolBlueNoise, kSamplerSobolOwen}) {
            double sobol_64 = integration_error(kind, 64, axes);
            double sobol_1024 = integration_error(kind, 1024, axes);
            EXPECT_LT(sobol_64, random_64 / 3) << kind << " " << axes;
            EXPECT_LT(sobol_1024, random_1024 / 5) << kind << " " << axes;
            EXPECT_GT(sobol_64 / sobol_1024, 8) << kind << " " << axes;
        }
    }
}

}  // namespace
}  // namespace hm
