// Walker's alias method (1977), built as Vose (1991): a discrete distribution that is sampled in
// constant time from two 32-bit integers.
#pragma once

#include <span>
#include <vector>

#include "shading/structs.h"

namespace hm {

// Entry i is drawn with probability weights[i] / sum. Weights are finite and not negative; if all
// are zero the table has pdf 0 everywhere. As many entries as weights.
std::vector<AliasEntry> build_alias_table(std::span<const float> weights);

}  // namespace hm
