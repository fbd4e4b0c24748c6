// How uncertain a picture is, from the film's replicates or, with independent samples, from the
// samples themselves.
#pragma once

#include <optional>
#include <vector>

#include "film/film.h"

namespace hm {

// The variance of each pixel's mean (its squared standard error): three floats per pixel, infinite
// where there are too few samples to tell. The film must carry Aov::variance.
//
// Of replicates: they are drawn in turn, so their sample counts differ by at most one, and
//     var = R / (R - 1) sum_r (n_r / n)^2 (m_r - m)^2.
// Of n samples: (mean of squares - square of the mean) / (n - 1).
std::vector<float> variance_of_means(const Film& film);

// What a comparison with the true picture is expected to find: the root of the mean of these
// variances over pixels and channels. Nothing where the film does not carry them or can't tell.
std::optional<double> estimated_error(const Film& film);

}  // namespace hm
