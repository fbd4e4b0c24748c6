// Byte arrays without initialisation.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace hm {

// For bytes that are all written before any is read: what resize() adds is left unset.
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
