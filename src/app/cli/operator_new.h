// The program's global operator new, which the library leaves to its host: on Linux large
// allocations, and so every large std::vector, are aligned to huge pages.
#pragma once

#include <cstddef>

namespace hm::cli {

inline constexpr std::size_t kHugePage = std::size_t(1) << 21;

}  // namespace hm::cli
