#include "support/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hm::test {
namespace {

// Series for the lower and continued fraction (Lentz) for the upper gamma function, each used where
// it converges fast.
double gamma_p_series(double a, double x) {
    double term = 1 / a, sum = term;
    for (int n = 1; n < 10000 && term > sum * 1e-16; ++n) {
        term *= x / (a + n);
        sum += term;
    }
    return sum * std::exp(-x + a * std::log(x) - std::lgamma(a));
}

double gamma_q_fraction(double a, double x) {
    constexpr double kTiny = 1e-300;
    double b = x + 1 - a, c = 1 / kTiny, d = 1 / b, h = d;
    for (int i = 1; i < 10000; ++i) {
        double an = -i * (i - a);
        b += 2;
        d = an * d + b;
        if (std::abs(d) < kTiny) d = kTiny;
        c = b + an / c;
        if (std::abs(c) < kTiny) c = kTiny;
        d = 1 / d;
        double step = d * c;
        h *= step;
        if (std::abs(step - 1) < 1e-15) break;
    }
    return h * std::exp(-x + a * std::log(x) - std::lgamma(a));
}

// Continued fraction (Lentz) of the incomplete beta function, for x < (a + 1) / (a + b + 2).
double beta_fraction(double a, double b, double x) {
    constexpr double kTiny = 1e-300;
    double c = 1, d = 1 - (a + b) * x / (a + 1);
    d = 1 / (std::abs(d) < kTiny ? kTiny : d);
    double h = d;
    auto step = [&](double an) {
        d = 1 + an * d;
        c = 1 + an / c;
        d = 1 / (std::abs(d) < kTiny ? kTiny : d);
        if (std::abs(c) < kTiny) c = kTiny;
        h *= d * c;
        return std::abs(d * c - 1) > 1e-15;
    };
    for (int m = 1; m < 10000; ++m) {
        step(m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)));
        if (!step(-(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1)))) break;
    }
    return h;
}

double incomplete_beta(double a, double b, double x) {
    double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) +
                            b * std::log1p(-x));
    if (x < (a + 1) / (a + b + 2)) return front * beta_fraction(a, b, x) / a;
    return 1 - front * beta_fraction(b, a, 1 - x) / b;
}

}  // namespace

double gamma_q(double a, double x) {
    if (x <= 0) return 1;
    return x < a + 1 ? 1 - gamma_p_series(a, x) : gamma_q_fraction(a, x);
}

double normal_tail(double z) {
    return std::erfc(std::abs(z) / std::sqrt(2.0));
}

double student_tail(double t, int degrees) {
    if (t == 0) return 1;
    return incomplete_beta(0.5 * degrees, 0.5, degrees / (degrees + t * t));
}

double sidak_level(double level, int count) {
    return -std::expm1(std::log1p(-level) / count);
}

ChiSquare chi_square(std::span<const std::uint64_t> observed, std::span<const double> expected) {
    ChiSquare result;
    int bins = 0;
    double o = 0, e = 0;
    double last_o = 0, last_e = 0;  // last closed bin, which takes the leftover
    auto close = [&] {
        result.statistic += (o - e) * (o - e) / e;
        ++bins;
        last_o = o;
        last_e = e;
        o = e = 0;
    };
    for (std::size_t i = 0; i < observed.size(); ++i) {
        o += double(observed[i]);
        e += expected[i];
        if (e >= 5) close();
    }
    if (bins > 0 && (o > 0 || e > 0)) {
        result.statistic -= (last_o - last_e) * (last_o - last_e) / last_e;
        --bins;
        o += last_o;
        e += last_e;
        close();
    }
    result.degrees = bins - 1;
    if (result.degrees > 0) result.p_value = gamma_q(0.5 * result.degrees, 0.5 * result.statistic);
    return result;
}

ChiSquare Histogram::test(std::span<const double> shares) const {
    std::vector<std::uint64_t> observed = counts;
    std::vector<double> expected(shares.begin(), shares.end());
    // Quadrature error leaves a little mass unaccounted for, which must not become a bin.
    double left = 1 - std::accumulate(shares.begin(), shares.end(), 0.0);
    if (rest > 0 || left * double(total) >= 5) {
        observed.push_back(rest);
        expected.push_back(std::max(left, 0.0));
    }
    for (double& e : expected)
        e *= double(total);
    return chi_square(observed, expected);
}

}  // namespace hm::test
