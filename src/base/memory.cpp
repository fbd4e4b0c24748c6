#include "base/memory.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hm {

void prefer_huge_pages(void* memory, std::size_t bytes) {
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const std::size_t skipped = (kHugePage - address % kHugePage) % kHugePage;
    if (bytes < skipped + kHugePage) return;
#if defined(__linux__)
    (void)madvise(static_cast<std::byte*>(memory) + skipped,
                  (bytes - skipped) / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
}

}  // namespace hm
