// An allocator that asks the system for huge pages: traversal reads nodes all over tens of
// megabytes, and with small pages it waits for address translation.
#pragma once

#include <cstddef>
#include <new>

#include "base/memory.h"

namespace hm {

template <class T>
struct HugePageAllocator {
    using value_type = T;

    HugePageAllocator() = default;
    template <class U>
    HugePageAllocator(const HugePageAllocator<U>&) {}

    static constexpr std::align_val_t alignment(std::size_t bytes) {
        return std::align_val_t(bytes >= kHugePage ? kHugePage : alignof(T));
    }
    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        void* memory = ::operator new(bytes, alignment(bytes));
        prefer_huge_pages(memory, bytes);
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        ::operator delete(memory, alignment(count * sizeof(T)));
    }
    bool operator==(const HugePageAllocator&) const { return true; }
};

}  // namespace hm
