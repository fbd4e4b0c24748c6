#include "compare/z_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/check.h"
#include "image/plane.h"

namespace hm {
namespace {

constexpr std::size_t kBlock = 8;

struct Sums {
    double a = 0, b = 0, variance = 0;

    void add(const Sums& more) {
        a += more.a;
        b += more.b;
        variance += more.variance;
    }
    double z() const {
        // Allows for float rounding; otherwise z could be infinite for equal constants.
        const double rounding = 1e-6 * (std::abs(a) + std::abs(b));
        const double difference = a - b, sigma = std::sqrt(variance + rounding * rounding);
        if (difference == 0) return 0;
        return sigma > 0 ? difference / sigma
                         : std::copysign(std::numeric_limits<double>::infinity(), difference);
    }
};

// The z that the absolute value of a standard normal variable exceeds with probability p.
double two_sided_quantile(double p) {
    double low = 0, high = 40;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::numbers::sqrt2) > p ? low : high) = middle;
    }
    return low;
}

}  // namespace

ZTest z_test(const FloatImage& a, const FloatImage& variance_a, const FloatImage& b,
             const FloatImage& variance_b) {
    const auto pa = color_planes(a), va = color_planes(variance_a);
    const auto pb = color_planes(b), vb = color_planes(variance_b);
    for (const FloatImage* other : {&variance_a, &b, &variance_b})
        HM_CHECK(other->width == a.width && other->height == a.height,
                 "{} x {} beside {} x {} pixels", other->width, other->height, a.width, a.height);
    const std::size_t columns = (a.width + kBlock - 1) / kBlock;
    const std::size_t rows = (a.height + kBlock - 1) / kBlock;
    std::array<Sums, 3> whole;
    std::vector<Sums> blocks(3 * columns * rows);
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < pa[c].values.size(); ++i) {
            const Sums pixel{double(pa[c].values[i]), double(pb[c].values[i]),
                             double(va[c].values[i]) + double(vb[c].values[i])};
            if (!std::isfinite(pixel.a + pixel.b + pixel.variance)) continue;
            const std::size_t x = i % a.width / kBlock, y = i / a.width / kBlock;
            blocks[(c * rows + y) * columns + x].add(pixel);
            whole[c].add(pixel);
        }

    ZTest test;
    test.comparisons = blocks.size() + whole.size();
    test.threshold = two_sided_quantile(kZTestLevel / double(test.comparisons));
    const auto judge = [&](const Sums& sums) {
        const double z = sums.z();
        test.largest = std::max(test.largest, std::abs(z));
        if (std::abs(z) > test.threshold) ++test.beyond;
        return z;
    };
    for (const Sums& block : blocks)
        judge(block);
    for (std::size_t c = 0; c < 3; ++c)
        test.whole[c] = judge(whole[c]);
    return test;
}

}  // namespace hm
