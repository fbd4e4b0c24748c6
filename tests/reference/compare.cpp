#include "reference/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/statistics.h"

namespace hm::test {
namespace {

constexpr std::uint32_t kBlock = 8;
// Both renderers compute in float: where neither has noise, values still differ by this much.
constexpr double kFloatError = 1e-5;
// A pixel with a rare contribution (such as a distant edge) may not have sampled it in any
// replicate, so its variance is meaningless: pixel values are assumed to be known to this relative
// error at best.
constexpr double kPixelError = 1e-3;

double squared_error(double ours, double reference, double value, double floor) {
    return ours + reference + value * value * floor * floor;
}

// Welch and Satterthwaite's degrees of freedom of the difference of two means.
double welch_degrees(double a, int count_a, double b, int count_b) {
    const double sum = a + b;
    if (!(sum > 0)) return count_a + count_b - 2;
    return sum * sum / (a * a / (count_a - 1) + b * b / (count_b - 1));
}

// The sums of mean and variance over a rectangle of pixels, of one channel.
struct Total {
    double ours = 0, reference = 0, our_variance = 0, reference_variance = 0;

    void add(const Estimate& a, const Estimate& b, std::size_t i) {
        ours += a.mean[i];
        reference += b.mean[i];
        our_variance += a.variance[i];
        reference_variance += b.variance[i];
    }
    double floor = kFloatError;  // relative

    double error() const {
        return std::sqrt(squared_error(our_variance, reference_variance, reference, floor));
    }
};

void keep_least_likely(Scale& scale, double p, const Total& total, int channel,
                       const std::string& where) {
    if (p >= scale.p_value) return;
    const double difference = total.ours - total.reference;
    scale = {p, difference / total.error(), difference / total.reference,
             fmt::format("channel {} of {}", "RGB"[channel], where)};
}

// Sums of many pixels' independent noise: close to normal, their variance well known.
Scale compare_blocks(const Estimate& ours, const Estimate& reference, std::uint32_t bw,
                     std::uint32_t bh) {
    Scale scale{2, 0, 0, ""};
    int count = 0;
    for (std::uint32_t y = 0; y < ours.height; y += bh)
        for (std::uint32_t x = 0; x < ours.width; x += bw)
            for (std::size_t c = 0; c < 3; ++c) {
                Total total;
                for (std::uint32_t j = y; j < std::min(y + bh, ours.height); ++j)
                    for (std::uint32_t i = x; i < std::min(x + bw, ours.width); ++i)
                        total.add(ours, reference, 3 * (std::size_t(j) * ours.width + i) + c);
                ++count;
                const double error = total.error();
                const double difference = total.ours - total.reference;
                const double p = error > 0 ? normal_tail(difference / error) : 1;
                const bool all = bw == ours.width && bh == ours.height;
                keep_least_likely(scale, p, total, int(c),
                                  all ? "the picture" : fmt::format("the block at {}, {}", x, y));
            }
    scale.p_value = std::min(1.0, scale.p_value * count);
    return scale;
}

Scale compare_pixels(const Estimate& ours, const Estimate& reference) {
    Scale scale{2, 0, 0, ""};
    for (std::size_t i = 0; i < ours.mean.size(); ++i) {
        Total total;
        total.floor = kPixelError;
        total.add(ours, reference, i);
        const double error = total.error();
        if (!(error > 0)) continue;
        const double degrees = welch_degrees(ours.variance[i], ours.replicates,
                                             reference.variance[i], reference.replicates);
        const double p = student_tail((total.ours - total.reference) / error, degrees);
        const std::size_t pixel = i / 3;
        keep_least_likely(scale, p, total, int(i % 3),
                          fmt::format("pixel {}, {}", pixel % ours.width, pixel / ours.width));
    }
    scale.p_value = std::min(1.0, scale.p_value * double(ours.mean.size()));
    return scale;
}

}  // namespace

Estimate estimate(std::uint32_t width, std::uint32_t height, int replicates,
                  const std::vector<double>& sum, const std::vector<double>& sum_of_squares) {
    Estimate e{width, height, replicates, {}, {}};
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const double mean = sum[i] / replicates;
        const double spread = sum_of_squares[i] / replicates - mean * mean;
        e.mean.push_back(mean);
        e.variance.push_back(std::max(spread, 0.0) / (replicates - 1));
    }
    return e;
}

double student_tail(double t, double degrees) {
    // Twice the density's integral over s >= |t|, by Simpson's rule in log s.
    const double low = std::log(std::max(std::abs(t), 1e-9));
    const double high = low + 40;
    constexpr int kSteps = 2000;
    double sum = 0;
    for (int i = 0; i <= kSteps; ++i) {
        const double s = std::exp(low + (high - low) * i / kSteps);
        const double f = s * std::exp(-0.5 * (degrees + 1) * std::log1p(s * s / degrees));
        sum += f * (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2);
    }
    const double norm = std::lgamma(0.5 * (degrees + 1)) - std::lgamma(0.5 * degrees) -
                        0.5 * std::log(degrees * 3.14159265358979323846);
    return std::min(1.0, 2 * std::exp(norm) * sum * (high - low) / kSteps / 3);
}

Comparison compare(const Estimate& ours, const Estimate& reference) {
    Comparison c;
    c.pixels = compare_pixels(ours, reference);
    c.blocks = compare_blocks(ours, reference, kBlock, kBlock);
    c.picture = compare_blocks(ours, reference, ours.width, ours.height);
    Total all;
    for (std::size_t i = 0; i < ours.mean.size(); ++i)
        all.add(ours, reference, i);
    c.picture_error = all.error() / all.reference;
    return c;
}

FloatImage difference_image(const Estimate& ours, const Estimate& reference, bool in_errors) {
    FloatImage image(ours.width, ours.height);
    for (std::size_t i = 0; i < ours.mean.size(); ++i) {
        Total total;
        total.add(ours, reference, i);
        const double unit = in_errors ? std::max(total.error(), 1e-30) : 1;
        image.pixels[i / 3][i % 3] = float((total.ours - total.reference) / unit);
        image.pixels[i / 3][3] = 1;
    }
    return image;
}

}  // namespace hm::test
