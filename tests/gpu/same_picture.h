// When two pictures of the same samples count as the same (CPU and GPU; docs/testing.md).
#pragma once

#include <string>
#include <vector>

#include "film/film.h"
#include "shading/lang.h"

namespace hm::test {

using Pixels = std::vector<vec4>;  // means: radiance and alpha

Pixels means_of(const Film& film);

// For each channel: the mean within 1e-3 of its value or four standard errors of the paired
// differences, and 99 % of its pixels within 1e-2. Prints the differences, and returns how many
// pixels differ.
std::size_t expect_same_picture(const Pixels& gpu, const Pixels& cpu, const std::string& what);

}  // namespace hm::test
