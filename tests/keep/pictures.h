// Pictures in files, compared by their pixels: metadata tell how long a rendering took.
#pragma once

#include <string>

namespace hm::test {

// The same layers with the same bits.
void expect_same_pixels(const std::string& a, const std::string& b);

// The same layers, equal to `roundings` roundings of a float, or of 1 where that is more: terms of
// both signs leave what is small beside them. Variances, as differences of larger numbers, may
// differ a thousand times as much.
void expect_near_pixels(const std::string& a, const std::string& b, float roundings);

}  // namespace hm::test
