// Compares picture files by their pixels: the metadata contain times.
#pragma once

#include <string>

namespace hm::test {

// The same layers with the same bits.
void expect_same_pixels(const std::string& a, const std::string& b);

// The same layers, equal to `roundings` float roundings of the value or of 1, whichever is larger,
// because of cancellation. Variances, as differences of larger numbers, may differ a thousand times
// as much.
void expect_near_pixels(const std::string& a, const std::string& b, float roundings);

}  // namespace hm::test
