#include "gpu/batches.h"

#include <algorithm>

namespace hm {
namespace {

// The first submission, for a device of unknown speed.
constexpr double kFirstBudget = 1 << 14;

// Rows differ in cost: a budget grows by no more than this at a time.
constexpr double kGrowth = 4;

}  // namespace

BatchSizer::BatchSizer(std::uint32_t width, std::uint32_t height, std::uint64_t max_samples)
    : width_(width), height_(height), max_samples_(max_samples), budget_(kFirstBudget) {}

void BatchSizer::learn(const Batch& batch, double milliseconds) {
    const double done = double(batch.samples(width_));
    const double fitting = done * kBatchMilliseconds / std::max(milliseconds, 1e-3);
    budget_ = std::clamp(fitting, budget_ / kGrowth, budget_ * kGrowth);
}

std::uint32_t BatchSizer::rows() const {
    const double most = std::min(budget_, double(max_samples_)) / std::max(width_, 1u);
    return std::uint32_t(std::clamp(most, 1.0, double(height_)));
}

std::uint32_t BatchSizer::samples() const {
    if (rows() < height_) return 1;
    const double most =
        std::min(budget_, double(max_samples_)) / (double(width_) * double(height_));
    return std::uint32_t(std::clamp(most, 1.0, 1024.0));
}

std::optional<Batch> BatchCutter::next(const BatchSizer& sizer) {
    if (next_ >= end_) return std::nullopt;
    // A sample that was begun by bands is finished by bands.
    const bool whole = row_ == 0 && sizer.rows() >= height_;
    Batch batch;
    batch.first_row = row_;
    batch.rows = std::min(sizer.rows(), height_ - row_);
    batch.sample_begin = next_;
    batch.sample_end = whole ? std::min(end_, next_ + sizer.samples()) : next_ + 1;
    row_ += batch.rows;
    if (row_ == height_) {
        row_ = 0;
        next_ = batch.sample_end;
    }
    return batch;
}

}  // namespace hm
