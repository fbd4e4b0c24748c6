// Walker's alias method (1977) with Vose's construction (1991): samples a discrete distribution in
// constant time from two 32-bit integers.
#pragma once

#include <span>
#include <vector>

#include "shading/structs.h"

namespace hm {

// Entry i is sampled with probability weights[i] / sum. Weights are finite and non-negative; if all
// are zero, the pdf is 0 everywhere. The table has one entry per weight.
std::vector<AliasEntry> build_alias_table(std::span<const float> weights);

}  // namespace hm
