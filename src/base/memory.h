// Where the program's memory lies. On Linux every `new` of at least a huge page, and so every large
// std::vector, begins where a huge page may.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace hm {

inline constexpr std::size_t kHugePage = std::size_t(1) << 21;

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
