#include "gpu/same_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hm::test {

namespace {

struct Channel {
    double mean = 0;
    double difference = 0;
    double error = 0;  // of the difference, one standard deviation
    std::size_t off = 0;
};

Channel compare(const Pixels& gpu, const Pixels& cpu, std::size_t channel) {
    const auto count = static_cast<double>(cpu.size());
    Channel c;
    double squares = 0;
    for (std::size_t i = 0; i < cpu.size(); ++i) {
        const auto a = static_cast<double>(gpu[i][channel]);
        const auto b = static_cast<double>(cpu[i][channel]);
        c.mean += b / count;
        c.difference += (a - b) / count;
        squares += (a - b) * (a - b) / count;
        c.off += !(std::abs(a - b) <= 1e-2 * std::max(std::abs(a), std::abs(b))) ? 1u : 0u;
    }
    c.error = std::sqrt(std::max(squares - c.difference * c.difference, 0.0) / count);
    return c;
}

}  // namespace

Pixels means_of(const Film& film) {
    Pixels pixels;
    for (const PixelSum& s : film.sums)
        pixels.push_back(vec4(s.radiance, s.alpha) / s.weight);
    return pixels;
}

std::size_t expect_same_picture(const Pixels& gpu, const Pixels& cpu, const std::string& what) {
    EXPECT_EQ(gpu.size(), cpu.size());
    std::printf("%-48s", what.c_str());
    std::size_t most = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const Channel c = compare(gpu, cpu, k);
        EXPECT_LE(std::abs(c.difference), std::max(1e-3 * c.mean, 4 * c.error))
            << what << ", channel " << k << ", mean " << c.mean;
        EXPECT_LE(c.off, cpu.size() / 100) << what << ", channel " << k;
        if (k < 3) std::printf("  %8.5f %+.0e", c.mean, c.difference);
        most = std::max(most, c.off);
    }
    std::printf("  %zu of %zu pixels off\n", most, cpu.size());
    std::fflush(stdout);
    return most;
}

}  // namespace hm::test
