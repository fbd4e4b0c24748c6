// How much work one submission gets (rows of the picture times samples), so that it runs for about
// kBatchMilliseconds: long enough to fill a device, short enough that no driver times out and
// cancelling is quick. And whether its samples share a launch. Plain data; timings only decide
// where a picture is split, which does not change the result.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gpu/launch_choice.h"

namespace hm {

inline constexpr double kBatchMilliseconds = 40;

// Samples [sample_begin, sample_end) of the rows [first_row, first_row + rows).
struct Batch {
    std::uint32_t first_row = 0;
    std::uint32_t rows = 0;
    std::uint32_t sample_begin = 0;
    std::uint32_t sample_end = 0;
    Launches launches = Launches::loop;

    std::uint32_t samples_per_pixel() const { return sample_end - sample_begin; }
    std::uint64_t samples(std::uint32_t width) const {
        return std::uint64_t(width) * rows * samples_per_pixel();
    }
};

// Learns from timings how many samples of a pixel fit a batch with either way of launching them,
// and which way is faster.
class BatchSizer {
  public:
    BatchSizer() = default;
    // max_samples: in one batch, over all its pixels.
    BatchSizer(std::uint32_t width, std::uint32_t height, std::uint64_t max_samples);

    // Batches in the order in which they were cut.
    void learn(const Batch& batch, double milliseconds);
    // Of the next batch.
    Launches next_launches() { return launches_.next(); }
    // How many rows, and if that is all rows, how many samples of each pixel.
    std::uint32_t rows(Launches launches) const;
    std::uint32_t samples(Launches launches) const;
    std::optional<Launches> decided() const { return launches_.decided(); }

  private:
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    std::uint64_t max_samples_ = 0;
    std::array<double, 2> budgets_{};  // samples per batch that fit the time, by Launches
    LaunchChoice launches_;
};

// Cuts [begin, end) of all rows into batches: several samples of all rows, or, if one sample of
// all rows is too much, bands of rows of one sample.
class BatchCutter {
  public:
    BatchCutter(std::uint32_t height, std::uint32_t begin, std::uint32_t end)
        : height_(height), next_(begin), end_(end) {}
    // None when all is done.
    std::optional<Batch> next(BatchSizer& sizer);
    // Whether all rows have as many samples.
    bool is_even() const { return row_ == 0; }

  private:
    std::uint32_t height_;
    std::uint32_t next_;
    std::uint32_t end_;
    std::uint32_t row_ = 0;  // of sample next_, where the band begins
};

}  // namespace hm
