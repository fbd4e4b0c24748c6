// What the program asks of the system's memory beyond taking it.
#pragma once

#include <cstddef>

namespace hm {

inline constexpr std::size_t kHugePage = std::size_t(1) << 21;

// For memory that was taken, is not touched yet and will be used nearly whole: filled with small
// pages, its first touch costs more than most things that are done with it. Only a hint, for the
// huge pages that lie within; without them all works, more slowly.
void prefer_huge_pages(void* memory, std::size_t bytes);

}  // namespace hm
