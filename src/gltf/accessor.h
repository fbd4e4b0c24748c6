// Reading accessors' elements: every component type, strides and sparse replacement.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gltf/source.h"

namespace hm::gltf {

std::string accessor_place(std::size_t accessor);

// All components of all elements, one after the other; normalized integers as 0..1 or -1..1. Of
// matrices only those of floats.
Result<std::vector<float>> read_floats(const Source& source, std::size_t accessor);

// All components, which are unsigned integers.
Result<std::vector<std::uint32_t>> read_integers(const Source& source, std::size_t accessor);

// Where components go: those of element i from `first` + i * `stride` on.
template <class T>
struct Target {
    T* first;
    std::size_t stride;
};

// The same into memory that is there already, on several threads where it is much.
Result<void> read_floats_to(const Source& source, std::size_t accessor, Target<float> to);
Result<void> read_integers_to(const Source& source, std::size_t accessor, Target<std::uint32_t> to);

// An error at the accessor that names the first element with a NaN or an infinity.
Result<void> check_finite(const Source& source, std::size_t accessor,
                          const std::vector<float>& values);
Result<void> check_finite(const Source& source, std::size_t accessor, Target<const float> values);

// Warns where the file's min and max, which only some uses of accessors need, are missing or are
// not those of these values.
void check_limits(Source& source, std::size_t accessor, Target<const float> values);

// Warns where elements do not start at multiples of 4 bytes, as those of vertex data do (3.6.2.4).
void check_alignment(Source& source, std::size_t accessor);

}  // namespace hm::gltf
