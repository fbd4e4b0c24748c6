// Pictures without NaN and infinity, for filters that would spread them.
#pragma once

#include <cstdint>
#include <span>

namespace hm {

// A pixel with a value that is not finite becomes the mean of its finite neighbours among the eight
// around it; larger holes are filled from their edges inwards. 0 if no pixel is finite. Returns how
// many there were. `values` holds rows of `width`
// pixels with `channels` floats each.
std::uint64_t replace_non_finite(std::span<float> values, std::size_t width, std::size_t channels);

}  // namespace hm
