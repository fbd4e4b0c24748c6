// Sets of flags from scoped enums: specialise kIsFlags for an enum to combine its values with |.
#pragma once

#include <type_traits>

namespace hm::rhi {

template <class E>
inline constexpr bool kIsFlags = false;

template <class E>
requires kIsFlags<E>
constexpr E operator|(E a, E b) {
    using U = std::underlying_type_t<E>;
    return static_cast<E>(static_cast<U>(a) | static_cast<U>(b));
}

// Whether `set` holds every flag of `flags`.
template <class E>
requires kIsFlags<E>
constexpr bool has(E set, E flags) {
    using U = std::underlying_type_t<E>;
    return (static_cast<U>(set) & static_cast<U>(flags)) == static_cast<U>(flags);
}

}  // namespace hm::rhi
