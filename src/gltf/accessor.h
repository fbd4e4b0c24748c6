// Reading accessors' elements: every component type, strides and sparse replacement.
#pragma once

#include <cstdint>
#include <initializer_list>
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

// An error at the accessor that names the first element with a NaN or an infinity.
Result<void> check_finite(const Source& source, std::size_t accessor,
                          const std::vector<float>& values);

}  // namespace hm::gltf
