#include "compare/ssim.h"

#include "base/check.h"

namespace hm {
namespace {

constexpr std::uint32_t kRadius = 5;

Plane product(const Plane& a, const Plane& b) {
    Plane out(a.width, a.height);
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = a.values[i] * b.values[i];
    return out;
}

Plane window_means(const Plane& plane) {
    const Kernel kernel = gaussian_kernel(1.5, int(kRadius));
    return filter_columns(filter_rows(plane, kernel), kernel);
}

}  // namespace

std::optional<double> ssim(const Plane& a, const Plane& b) {
    HM_CHECK(a.width == b.width && a.height == b.height, "{} x {} and {} x {} pixels", a.width,
             a.height, b.width, b.height);
    if (a.width <= 2 * kRadius || a.height <= 2 * kRadius) return std::nullopt;
    constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
    const Plane mean_a = window_means(a), mean_b = window_means(b);
    const Plane aa = window_means(product(a, a)), bb = window_means(product(b, b));
    const Plane ab = window_means(product(a, b));

    double sum = 0;
    // Windows that cross the border are excluded.
    for (std::size_t y = kRadius; y < a.height - kRadius; ++y)
        for (std::size_t x = kRadius; x < a.width - kRadius; ++x) {
            const std::size_t i = y * a.width + x;
            const double ma = double(mean_a.values[i]), mb = double(mean_b.values[i]);
            const double variances =
                double(aa.values[i]) - ma * ma + double(bb.values[i]) - mb * mb;
            const double covariance = double(ab.values[i]) - ma * mb;
            sum += (2 * ma * mb + kC1) * (2 * covariance + kC2) /
                   ((ma * ma + mb * mb + kC1) * (variances + kC2));
        }
    return sum / (double(a.width - 2 * kRadius) * double(a.height - 2 * kRadius));
}

}  // namespace hm
