// A number or a vector as the floats that it consists of.
#pragma once

#include <span>
#include <type_traits>

namespace hm {

inline std::span<float> components(float& value) {
    return {&value, 1};
}
inline std::span<const float> components(const float& value) {
    return {&value, 1};
}
template <class Vector>
auto components(Vector& value) {
    using Float = std::conditional_t<std::is_const_v<Vector>, const float, float>;
    return std::span<Float>(&value[0], std::size_t(Vector::length()));
}

}  // namespace hm
