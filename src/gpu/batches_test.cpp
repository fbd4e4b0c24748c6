// Batches cover every sample of every row once and in order, whatever the timings.
#include "gpu/batches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace hm {
namespace {

// Cuts [begin, end) with batches that take `nanoseconds` per sample of a pixel, and checks that
// each row gets its samples in order. Returns the batches.
std::vector<Batch> cut(std::uint32_t width, std::uint32_t height, std::uint32_t begin,
                       std::uint32_t end, double nanoseconds) {
    BatchSizer sizer(width, height, 1u << 30);
    BatchCutter cutter(height, begin, end);
    std::vector<std::uint32_t> next(height, begin);
    std::vector<Batch> batches;
    while (const auto batch = cutter.next(sizer)) {
        EXPECT_GT(batch->rows, 0u);
        EXPECT_LE(batch->first_row + batch->rows, height);
        for (std::uint32_t row = batch->first_row; row < batch->first_row + batch->rows; ++row) {
            EXPECT_EQ(next[row], batch->sample_begin);
            next[row] = batch->sample_end;
        }
        batches.push_back(*batch);
        sizer.learn(*batch, double(batch->samples(width)) * nanoseconds * 1e-6);
    }
    EXPECT_EQ(next, std::vector<std::uint32_t>(height, end));
    return batches;
}

double milliseconds(const Batch& batch, std::uint32_t width, double nanoseconds) {
    return double(batch.samples(width)) * nanoseconds * 1e-6;
}

TEST(Batches, AFastDeviceTakesManySamplesOfThePicture) {
    const std::vector<Batch> batches = cut(640, 360, 0, 4096, 1.0);
    const Batch& settled = batches[batches.size() / 2];
    EXPECT_EQ(settled.rows, 360u);
    EXPECT_NEAR(milliseconds(settled, 640, 1.0), kBatchMilliseconds, 1.0);
}

TEST(Batches, ASlowDeviceTakesBandsOfOneSample) {
    const std::vector<Batch> batches = cut(1920, 1080, 3, 5, 100.0);
    const Batch& settled = *std::max_element(batches.begin(), batches.end(),
                                             [](auto& a, auto& b) { return a.rows < b.rows; });
    EXPECT_LT(settled.rows, 1080u);
    EXPECT_EQ(settled.sample_end - settled.sample_begin, 1u);
    EXPECT_NEAR(milliseconds(settled, 1920, 100.0), kBatchMilliseconds, 1.0);
}

TEST(Batches, StartShortAndGrowGradually) {
    const std::vector<Batch> batches = cut(4096, 4096, 0, 8, 1.0);
    EXPECT_LE(batches[0].samples(4096), 1u << 14);
    for (std::size_t i = 1; i < batches.size(); ++i)
        EXPECT_LE(batches[i].samples(4096), 5 * batches[i - 1].samples(4096) + 4096 * 4) << i;
}

TEST(Batches, NoLaunchIsLargerThanTheDeviceTakes) {
    BatchSizer sizer(1000, 1000, 50'000);
    for (int i = 0; i < 20; ++i)
        sizer.learn({0, 1000, 0, 1}, 1e-3);
    EXPECT_EQ(sizer.rows(Launches::loop), 50u);
}

// Whole pictures of 40 ms show which launch mode is faster, and no batch takes longer, however slow
// the other mode is.
TEST(Batches, TheFasterWayOfLaunchingIsFoundInTime) {
    for (const double ratio : {0.1, 0.9, 1.1, 20.0}) {
        BatchSizer sizer(64, 64, 1u << 30);
        BatchCutter cutter(64, 0, 1u << 20);
        Launches last{};
        for (int i = 0; i < 60; ++i) {
            const Batch batch = *cutter.next(sizer);
            last = batch.launches;
            const double faster = batch.launches == Launches::loop ? 1 : ratio;
            const double ms = milliseconds(batch, 64, 10.0 * faster);
            EXPECT_LE(ms, 1.01 * kBatchMilliseconds) << ratio << " " << i;
            sizer.learn(batch, ms);
        }
        EXPECT_EQ(last, ratio > 1 ? Launches::loop : Launches::one_per_sample) << ratio;
        EXPECT_EQ(sizer.decided(), last) << ratio;
    }
}

// If a batch is one sample or a band of one, both launch modes are the same.
TEST(Batches, SingleSamplesTellNothingOfLaunches) {
    BatchSizer sizer(1920, 1080, 1u << 30);
    BatchCutter cutter(1080, 0, 40);
    while (const auto batch = cutter.next(sizer)) {
        EXPECT_EQ(batch->samples_per_pixel(), 1u);
        sizer.learn(*batch, milliseconds(*batch, 1920, 15.0));
    }
    EXPECT_FALSE(sizer.decided());
}

TEST(Batches, APictureOfOneRowAndAnEmptyRange) {
    cut(1, 1, 0, 100, 1e6);
    EXPECT_TRUE(cut(10, 10, 4, 4, 1.0).empty());
}

}  // namespace
}  // namespace hm
