// Goodness of fit and significance for the statistical tests. All tests use fixed seeds, so a
// result never changes from run to run; the thresholds say how unlucky a correct program would be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace hm::test {

// Numbers for tests, by std::mt19937_64's raw output: the same on every standard library.
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

// The chance that a standard normal number lies farther from zero than z.
double normal_tail(double z);

// The chance that |t| of Student's distribution with so many degrees of freedom is larger.
double student_tail(double t, int degrees);

// All statistical comparisons of the suite together wrongly fail with this chance; each gets its
// share by Šidák's correction.
inline constexpr double kFamilyLevel = 1e-3;
inline constexpr int kFamilySize = 4000;

// The level of one comparison if there are `count`, for `level` in all.
double sidak_level(double level, int count);
inline double single_level() {
    return sidak_level(kFamilyLevel, kFamilySize);
}

struct ChiSquare {
    double statistic = 0;
    int degrees = 0;
    double p_value = 1;
};

// Pearson's test of counts against expected counts. Neighbouring bins are merged until each expects
// five.
ChiSquare chi_square(std::span<const std::uint64_t> observed, std::span<const double> expected);

// Counts over bins; merged with the expected shares when tested. Shares need not sum to one: what
// is missing belongs to the bin `rest` of samples that fall outside.
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
