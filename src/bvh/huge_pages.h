// An allocator that asks the system for huge pages: traversal reads nodes all over tens of
// megabytes, and with small pages it waits for address translation.
#pragma once

#include <cstddef>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hm {

template <class T>
struct HugePageAllocator {
    using value_type = T;
    static constexpr std::size_t kHugePage = std::size_t(1) << 21;

    HugePageAllocator() = default;
    template <class U>
    HugePageAllocator(const HugePageAllocator<U>&) {}

    static constexpr std::align_val_t alignment(std::size_t bytes) {
        return std::align_val_t(bytes >= kHugePage ? kHugePage : alignof(T));
    }
    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        void* memory = ::operator new(bytes, alignment(bytes));
#if defined(__linux__)
        // Only a hint: without huge pages all works, more slowly.
        if (bytes >= kHugePage) (void)madvise(memory, bytes, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        ::operator delete(memory, alignment(count * sizeof(T)));
    }
    bool operator==(const HugePageAllocator&) const {
        return true;
    }
};

}  // namespace hm
