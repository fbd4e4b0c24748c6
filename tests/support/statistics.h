// Goodness of fit and significance for the statistical tests. All tests use fixed seeds, so results
// never change between runs; the thresholds are the false positive rate of a correct program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace hm::test {

// Random numbers for tests from the raw output of std::mt19937_64: the same with every standard
// library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    std::uint32_t bits() { return std::uint32_t(engine_() >> 32); }
    float unit() { return float(bits() >> 8) * 0x1p-24f; }  // [0, 1)
    double unit_double() { return double(engine_() >> 11) * 0x1p-53; }
    float between(float low, float high) { return low + (high - low) * unit(); }

  private:
    std::mt19937_64 engine_;
};

// The regularised upper incomplete gamma function Q(a, x), a > 0, x >= 0.
double gamma_q(double a, double x);

// Two-sided tail probability of the standard normal distribution beyond z.
double normal_tail(double z);

// Two-sided tail probability of Student's t distribution with this number of degrees of freedom.
double student_tail(double t, int degrees);

// Family-wise error rate: the probability that any statistical comparison of the suite fails
// wrongly. Each comparison gets its level by the Šidák correction.
inline constexpr double kFamilyLevel = 1e-3;
inline constexpr int kFamilySize = 4000;

// Significance level of one of `count` comparisons, for a family-wise `level`.
double sidak_level(double level, int count);
inline double single_level() {
    return sidak_level(kFamilyLevel, kFamilySize);
}

struct ChiSquare {
    double statistic = 0;
    int degrees = 0;
    double p_value = 1;
};

// Pearson's chi-square test of observed against expected counts. Neighbouring bins are merged until
// each has an expected count of at least five.
ChiSquare chi_square(std::span<const std::uint64_t> observed, std::span<const double> expected);

// Counts per bin, tested against expected probabilities. These need not sum to one: the remainder
// is the probability of the bin `rest`, for samples outside of all bins.
struct Histogram {
    std::vector<std::uint64_t> counts;
    std::uint64_t rest = 0;
    std::uint64_t total = 0;

    explicit Histogram(std::size_t bins) : counts(bins) {}
    void add(std::size_t bin) {
        ++counts[bin];
        ++total;
    }
    void add_rest() {
        ++rest;
        ++total;
    }
    ChiSquare test(std::span<const double> shares) const;
};

}  // namespace hm::test
