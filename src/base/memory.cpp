#include "base/memory.h"

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#endif

namespace hm {

void prefer_huge_pages(void* memory, std::size_t bytes) {
    if (bytes < kHugePage) return;
#if defined(__linux__)
    // From the page where the memory begins: large pieces lie where a huge page may, but for what
    // the allocator notes in front of them.
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const std::uintptr_t before = reinterpret_cast<std::uintptr_t>(memory) % page;
    (void)::madvise(static_cast<std::byte*>(memory) - before, bytes + before, MADV_HUGEPAGE);
#endif
}

}  // namespace hm
