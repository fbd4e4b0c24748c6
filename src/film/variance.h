// Variance of a picture, estimated from the film's replicates or, with independent samples, from
// the samples themselves.
#pragma once

#include <optional>
#include <vector>

#include "film/film.h"

namespace hm {

// The variance of each pixel's mean (its squared standard error): three floats per pixel, infinite
// if there are too few samples. The film must have Aov::variance.
//
// From R replicates, which get samples in turn, so that their counts differ by at most one:
//     var = R / (R - 1) sum_r (n_r / n)^2 (m_r - m)^2.
// From n samples: (mean of squares - square of the mean) / (n - 1).
std::vector<float> variance_of_means(const Film& film);

// The expected RMSE against the true picture: the square root of the mean of these variances over
// pixels and channels. nullopt if the film has no variance or a variance is infinite.
std::optional<double> estimated_error(const Film& film);

}  // namespace hm
