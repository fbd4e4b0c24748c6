// The one file that knows the language. Everything in shading/ is GLSL 4.6 and C++20 at once; here
// C++ gets GLSL's names from glm, and GLSL gets the few macros C++ needs.
//
// Rules for the files that include this: no swizzles, enums, struct constructors or overloads;
// literals carry f or u; one random number per statement; never pass a variable twice to a function
// that writes it. Words reserved in GLSL (input, output, sample, filter, half, common, ...) stay
// out. What decides where a ray goes divides by divide(); what only weights a path may use
// fast_sqrt and fast_normalize, in functions marked HM_MAY_CONTRACT (exact.glsl has the reason).
#ifndef HM_SHADING_LANG_H
#define HM_SHADING_LANG_H

#ifdef __cplusplus

#define HM_EXTENDED  // see material/extended_lobes.h

#include <bit>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/mat4x3.hpp>

#define HM_NAMESPACE_BEGIN namespace hm {
#define HM_NAMESPACE_END }
#define HM_FN inline
#define HM_CONST static constexpr
#define HM_OUT(T) T&
#define HM_INOUT(T) T&
#define HM_IN(T) const T&   // a struct that is only read
#define HM_ROW(T) const T&  // an element of a table
#define HM_HOOK(declaration)
#define HM_MAY_CONTRACT

namespace hm {
using uint = std::uint32_t;
using glm::ivec2;
using glm::mat3;
using glm::mat4x3;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

using glm::abs;
using glm::clamp;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::exp2;
using glm::floor;
using glm::fract;
using glm::inversesqrt;
using glm::length;  // in GLSL as the device rounds it
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::pow;
using glm::sqrt;

inline uint float_bits(float x) {
    return std::bit_cast<uint>(x);
}
inline float bits_float(uint x) {
    return std::bit_cast<float>(x);
}
inline float divide(float a, float b) {
    return a / b;
}
inline float fast_sqrt(float x) {
    return sqrt(x);
}
inline vec3 fast_normalize(vec3 v) {
    return normalize(v);
}
// The upper half of the 64-bit product: maps a uniform 32-bit integer onto 0..n-1.
inline uint mul_high(uint a, uint b) {
    return uint((std::uint64_t(a) * std::uint64_t(b)) >> 32);
}
// The number of the lowest bit that is set; x is not 0.
inline uint lowest_bit(uint x) {
    return uint(std::countr_zero(x));
}
inline uint reverse_bits(uint x) {
    x = __builtin_bswap32(x);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}
}  // namespace hm

#else  // GLSL

#define HM_NAMESPACE_BEGIN
#define HM_NAMESPACE_END
#define HM_FN
#define HM_CONST const
#define HM_OUT(T) out T
#define HM_INOUT(T) inout T
#define HM_IN(T) T
#define HM_ROW(T) T
#define HM_HOOK(declaration) declaration;
#define HM_MAY_CONTRACT bool hm_may_contract = true;  // for tools/embed_spirv

#include "shading/exact.glsl"

uint float_bits(float x) {
    return floatBitsToUint(x);
}
float bits_float(uint x) {
    return uintBitsToFloat(x);
}
uint mul_high(uint a, uint b) {
    uint high;
    uint low;
    umulExtended(a, b, high, low);
    return high;
}
uint lowest_bit(uint x) {
    return uint(findLSB(x));
}
uint reverse_bits(uint x) {
    return bitfieldReverse(x);
}

#endif

#endif
