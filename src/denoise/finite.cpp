#include "denoise/finite.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"

namespace hm {
namespace {

bool is_finite(std::span<const float> pixel) {
    return std::all_of(pixel.begin(), pixel.end(), [](float v) { return std::isfinite(v); });
}

}  // namespace

std::uint64_t replace_non_finite(std::span<float> values, std::size_t width, std::size_t channels) {
    HM_CHECK(width > 0 && channels > 0 && values.size() % (width * channels) == 0,
             "{} values, {} pixels wide, {} channels", values.size(), width, channels);
    const std::size_t count = values.size() / channels, height = count / width;
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < count; ++i)
        if (!is_finite(values.subspan(i * channels, channels))) broken.push_back(i);

    // All means are taken before any is written, so that none depends on another.
    std::vector<float> means;
    means.reserve(broken.size() * channels);
    for (const std::size_t i : broken) {
        std::vector<double> sum(channels, 0.0);
        double found = 0;
        const std::size_t x = i % width, y = i / width;
        for (std::size_t v = y - (y > 0); v <= std::min(y + 1, height - 1); ++v)
            for (std::size_t u = x - (x > 0); u <= std::min(x + 1, width - 1); ++u) {
                const auto pixel = values.subspan((v * width + u) * channels, channels);
                if (!is_finite(pixel)) continue;
                for (std::size_t c = 0; c < channels; ++c)
                    sum[c] += double(pixel[c]);
                ++found;
            }
        for (const double s : sum)
            means.push_back(found > 0 ? float(s / found) : 0.0f);
    }
    for (std::size_t n = 0; n < broken.size(); ++n)
        std::copy_n(means.begin() + std::ptrdiff_t(n * channels), channels,
                    values.begin() + std::ptrdiff_t(broken[n] * channels));
    return broken.size();
}

}  // namespace hm
