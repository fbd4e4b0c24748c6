#include "denoise/finite.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/check.h"

namespace hm {
namespace {

bool is_finite(std::span<const float> pixel) {
    return std::all_of(pixel.begin(), pixel.end(), [](float v) { return std::isfinite(v); });
}

// Mean of the finite pixels among pixel i and its neighbours; nullopt if there are none.
std::optional<std::vector<float>> mean_around(std::size_t i, std::span<const float> values,
                                              std::size_t width, std::size_t channels) {
    const std::size_t height = values.size() / channels / width;
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
    if (found == 0) return std::nullopt;
    std::vector<float> mean;
    for (const double s : sum)
        mean.push_back(float(s / found));
    return mean;
}

}  // namespace

std::uint64_t replace_non_finite(std::span<float> values, std::size_t width, std::size_t channels) {
    HM_CHECK(width > 0 && channels > 0 && values.size() % (width * channels) == 0,
             "{} values, {} pixels wide, {} channels", values.size(), width, channels);
    const std::size_t count = values.size() / channels;
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < count; ++i)
        if (!is_finite(values.subspan(i * channels, channels))) broken.push_back(i);
    const std::uint64_t replaced = broken.size();
    if (replaced == count) {
        std::fill(values.begin(), values.end(), 0.0f);
        return replaced;
    }

    // Fills holes ring by ring from their edges: all means of a ring are computed before any is
    // written, so that they are independent.
    while (!broken.empty()) {
        std::vector<std::pair<std::size_t, std::vector<float>>> ring;
        std::vector<std::size_t> inside;
        for (const std::size_t i : broken) {
            if (auto mean = mean_around(i, values, width, channels))
                ring.emplace_back(i, std::move(*mean));
            else
                inside.push_back(i);
        }
        for (const auto& [i, mean] : ring)
            std::copy(mean.begin(), mean.end(), values.begin() + std::ptrdiff_t(i * channels));
        broken = std::move(inside);
    }
    return replaced;
}

}  // namespace hm
