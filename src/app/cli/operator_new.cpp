// The program's operator new: large allocations are aligned to huge pages, since page faults on
// small pages cost more than most of what is done with the memory
// (docs/decisions/0012-memory-in-huge-pages.md).
#include "app/cli/operator_new.h"

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)  // a sanitizer brings its own
#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

void* allocate(std::size_t bytes, std::size_t alignment) {
    const bool large = bytes >= hm::cli::kHugePage;
    if (!large && alignment <= alignof(std::max_align_t))
        return std::malloc(std::max<std::size_t>(bytes, 1));
    void* memory = nullptr;
    if (::posix_memalign(&memory, large ? std::max(alignment, hm::cli::kHugePage) : alignment,
                         bytes) != 0)
        return nullptr;
    // Only a hint: without huge pages everything works, but more slowly.
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

// The standard library's other forms call these.
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
