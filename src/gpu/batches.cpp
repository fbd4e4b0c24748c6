#include "gpu/batches.h"

#include <algorithm>

namespace hm {
namespace {

// The first submission, for a device of unknown speed.
constexpr double kFirstBudget = 1 << 14;

// Rows differ in cost, so a budget grows by at most this factor at a time.
constexpr double kGrowth = 4;

// The time of a shorter batch says little about the time of its samples.
constexpr double kTellingMilliseconds = 2;

}  // namespace

BatchSizer::BatchSizer(std::uint32_t width, std::uint32_t height, std::uint64_t max_samples)
    : width_(width), height_(height), max_samples_(max_samples) {
    budgets_.fill(kFirstBudget);
}

void BatchSizer::learn(const Batch& batch, double milliseconds) {
    const double done = double(batch.samples(width_));
    const double fitting = done * kBatchMilliseconds / std::max(milliseconds, 1e-3);
    const bool is_one = batch.samples_per_pixel() == 1;  // which is the same in either way
    for (const Launches launches : {Launches::loop, Launches::one_per_sample}) {
        double& budget = budgets_[std::size_t(launches)];
        if (is_one || launches == batch.launches)
            budget = std::clamp(fitting, budget / kGrowth, budget * kGrowth);
    }
    std::optional<double> telling;
    if (!is_one && milliseconds >= kTellingMilliseconds)
        telling = milliseconds / batch.samples_per_pixel();
    launches_.learn(batch.launches, telling);
}

std::uint32_t BatchSizer::rows(Launches launches) const {
    const double most = std::min(budgets_[std::size_t(launches)], double(max_samples_));
    return std::uint32_t(std::clamp(most / std::max(width_, 1u), 1.0, double(height_)));
}

std::uint32_t BatchSizer::samples(Launches launches) const {
    if (rows(launches) < height_) return 1;
    const double most = std::min(budgets_[std::size_t(launches)], double(max_samples_));
    return std::uint32_t(std::clamp(most / (double(width_) * double(height_)), 1.0, 1024.0));
}

std::optional<Batch> BatchCutter::next(BatchSizer& sizer) {
    if (next_ >= end_) return std::nullopt;
    Batch batch;
    batch.launches = sizer.next_launches();
    const std::uint32_t rows = sizer.rows(batch.launches);
    // A sample that was begun by bands is finished by bands.
    const bool whole = row_ == 0 && rows >= height_;
    batch.first_row = row_;
    batch.rows = std::min(rows, height_ - row_);
    batch.sample_begin = next_;
    batch.sample_end = whole ? std::min(end_, next_ + sizer.samples(batch.launches)) : next_ + 1;
    row_ += batch.rows;
    if (row_ == height_) {
        row_ = 0;
        next_ = batch.sample_end;
    }
    return batch;
}

}  // namespace hm
