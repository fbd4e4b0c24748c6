// Byte arrays that are not zero-initialised.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace hm {

// An allocator for bytes that are all written before any is read: resize() leaves new elements
// uninitialised.
struct UnsetBytes : std::allocator<std::byte> {
    template <class U>
    struct rebind {
        using other = UnsetBytes;
    };
    void construct(std::byte*) {}
    template <class... Arguments>
    void construct(std::byte* place, Arguments&&... arguments) {
        std::construct_at(place, std::forward<Arguments>(arguments)...);
    }
};

using ByteArray = std::vector<std::byte, UnsetBytes>;

}  // namespace hm
