// Compares image files by pixels only, as the metadata contain render times.
#pragma once

#include <string>

namespace hm::test {

// Expects the same layers, bit for bit.
void expect_same_pixels(const std::string& a, const std::string& b);

// Expects the same layers, equal to within `roundings` float roundings of max(value, 1), because of
// cancellation. Variances, being differences of larger numbers, get a thousand times the tolerance.
void expect_near_pixels(const std::string& a, const std::string& b, float roundings);

}  // namespace hm::test
