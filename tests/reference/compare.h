// Do two pictures have the same expectation? Each is known by its mean and the variance of that
// mean, from independent replicates.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image/image.h"

namespace hm::test {

struct Estimate {
    std::uint32_t width = 0, height = 0;
    int replicates = 0;
    std::vector<double> mean;      // three channels per pixel
    std::vector<double> variance;  // of the mean
};

// From the sums of replicates' pixel values and of their squares.
Estimate estimate(std::uint32_t width, std::uint32_t height, int replicates,
                  const std::vector<double>& sum, const std::vector<double>& sum_of_squares);

// The chance that |t| is at least this large, Student's t with `degrees` of freedom.
double student_tail(double t, double degrees);

// The least likely difference among pixels, blocks of 8 by 8 pixels, or whole-picture means, times
// how many were looked at (Bonferroni).
struct Scale {
    double p_value = 1;
    double z = 0;         // of that difference, in standard errors
    double relative = 0;  // the difference over the reference's value
    std::string where;
};

struct Comparison {
    Scale pixels, blocks, picture;
    double picture_error = 0;  // relative standard error of the whole picture's difference
};

Comparison compare(const Estimate& ours, const Estimate& reference);

// ours - reference, and the same in standard errors.
FloatImage difference_image(const Estimate& ours, const Estimate& reference, bool in_errors);

}  // namespace hm::test
