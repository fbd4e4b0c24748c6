// Decoding accessors: all component types, strides and sparse storage.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gltf/source.h"

namespace hm::gltf {

std::string accessor_pointer(std::size_t accessor);

// All components of all elements in order; normalized integers become 0..1 or -1..1. Matrices must
// be of floats.
Result<std::vector<float>> read_floats(const Source& source, std::size_t accessor);

// The same for unsigned integers, unconverted.
Result<std::vector<std::uint32_t>> read_integers(const Source& source, std::size_t accessor);

// Output layout: the components of element i start at `first` + i * `stride`.
template <class T>
struct Target {
    T* first;
    std::size_t stride;
};

// Decode into existing memory; large accessors are decoded on several threads.
Result<void> read_floats_to(const Source& source, std::size_t accessor, Target<float> to);
Result<void> read_integers_to(const Source& source, std::size_t accessor, Target<std::uint32_t> to);

// Fails at the accessor, naming the first element with a NaN or an infinity.
Result<void> check_finite(const Source& source, std::size_t accessor,
                          const std::vector<float>& values);
Result<void> check_finite(const Source& source, std::size_t accessor, Target<const float> values);

// Warns if the accessor's min and max are missing or do not match these values. Only some uses of
// accessors require them.
void check_limits(Source& source, std::size_t accessor, Target<const float> values);

// Warns if elements do not start at multiples of 4 bytes, which vertex data requires (3.6.2.4).
void check_alignment(Source& source, std::size_t accessor);

}  // namespace hm::gltf
