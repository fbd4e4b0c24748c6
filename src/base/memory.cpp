// The program's operator new: large pieces of memory begin where a huge page may. Filled for the
// first time in small pages, memory costs more than most things that are done with it
// (docs/decisions/0012-memory-in-huge-pages.md).
#include "base/memory.h"

#if defined(__linux__)
#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

void* allocate(std::size_t bytes, std::size_t alignment) {
    const bool large = bytes >= hm::kHugePage;
    if (!large && alignment <= alignof(std::max_align_t))
        return std::malloc(std::max<std::size_t>(bytes, 1));
    void* memory = nullptr;
    if (::posix_memalign(&memory, large ? std::max(alignment, hm::kHugePage) : alignment, bytes) !=
        0)
        return nullptr;
    // A hint, for the huge pages that lie within; without them all works, more slowly.
    if (large) (void)::madvise(memory, bytes, MADV_HUGEPAGE);
    return memory;
}

void* allocate_or_throw(std::size_t bytes, std::size_t alignment) {
    for (;;) {
        if (void* memory = allocate(bytes, alignment)) return memory;
        const std::new_handler make_room = std::get_new_handler();
        if (make_room == nullptr) throw std::bad_alloc();
        make_room();
    }
}

}  // namespace

// The library's other forms call these.
void* operator new(std::size_t bytes) {
    return allocate_or_throw(bytes, alignof(std::max_align_t));
}

void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate_or_throw(bytes, std::size_t(alignment));
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
#endif
