// Replaces NaN and infinity, which filters would spread.
#pragma once

#include <cstdint>
#include <span>

namespace hm {

// Replaces each pixel with a non-finite value by the mean of its finite neighbours among the eight
// around it; larger holes are filled from their edges inwards. 0 if no pixel is finite. Returns the
// number of replaced pixels. `values` are rows of `width` pixels with `channels` floats each.
std::uint64_t replace_non_finite(std::span<float> values, std::size_t width, std::size_t channels);

}  // namespace hm
