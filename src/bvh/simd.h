// Eight-wide float SIMD for bvh/traverse.h, which is compiled once per instruction set. Every
// operation is correctly rounded (IEEE 754), so all variants give bit-identical results.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#define HM_ALWAYS_INLINE inline __attribute__((always_inline))

namespace hm {

// Per lane, lowest(a, b) is a < b ? a : b and highest(a, b) is a > b ? a : b: both return b if
// either is NaN or both are zero. Comparisons return a bit per lane, false if either side is NaN.
#if defined(__AVX2__)

struct Float8 {
    __m256 v;
};
HM_ALWAYS_INLINE Float8 load8(const float* p) {
    return {_mm256_load_ps(p)};
}
HM_ALWAYS_INLINE void store8(float* p, Float8 a) {
    _mm256_store_ps(p, a.v);
}
HM_ALWAYS_INLINE Float8 splat8(float x) {
    return {_mm256_set1_ps(x)};
}
HM_ALWAYS_INLINE Float8 operator+(Float8 a, Float8 b) {
    return {_mm256_add_ps(a.v, b.v)};
}
HM_ALWAYS_INLINE Float8 operator-(Float8 a, Float8 b) {
    return {_mm256_sub_ps(a.v, b.v)};
}
HM_ALWAYS_INLINE Float8 operator*(Float8 a, Float8 b) {
    return {_mm256_mul_ps(a.v, b.v)};
}
HM_ALWAYS_INLINE Float8 operator/(Float8 a, Float8 b) {
    return {_mm256_div_ps(a.v, b.v)};
}
HM_ALWAYS_INLINE Float8 lowest(Float8 a, Float8 b) {
    return {_mm256_min_ps(a.v, b.v)};
}
HM_ALWAYS_INLINE Float8 highest(Float8 a, Float8 b) {
    return {_mm256_max_ps(a.v, b.v)};
}
#if defined(__AVX512F__) && defined(__AVX512VL__)
HM_ALWAYS_INLINE std::uint32_t mask_less(Float8 a, Float8 b) {
    return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ);
}
HM_ALWAYS_INLINE std::uint32_t mask_less_equal(Float8 a, Float8 b) {
    return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ);
}
HM_ALWAYS_INLINE std::uint32_t mask_differ(Float8 a, Float8 b) {
    return _mm256_cmp_ps_mask(a.v, b.v, _CMP_NEQ_OQ);
}
#else
HM_ALWAYS_INLINE std::uint32_t mask_less(Float8 a, Float8 b) {
    return std::uint32_t(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)));
}
HM_ALWAYS_INLINE std::uint32_t mask_less_equal(Float8 a, Float8 b) {
    return std::uint32_t(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}
HM_ALWAYS_INLINE std::uint32_t mask_differ(Float8 a, Float8 b) {
    return std::uint32_t(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_NEQ_OQ)));
}
#endif

#elif defined(__SSE2__)

struct Float8 {
    __m128 a, b;
};
HM_ALWAYS_INLINE Float8 load8(const float* p) {
    return {_mm_load_ps(p), _mm_load_ps(p + 4)};
}
HM_ALWAYS_INLINE void store8(float* p, Float8 x) {
    _mm_store_ps(p, x.a);
    _mm_store_ps(p + 4, x.b);
}
HM_ALWAYS_INLINE Float8 splat8(float x) {
    return {_mm_set1_ps(x), _mm_set1_ps(x)};
}
#define HM_EACH_HALF(f)          \
    Float8 {                     \
        f(x.a, y.a), f(x.b, y.b) \
    }
#define HM_MASK_OF(f) \
    (std::uint32_t(_mm_movemask_ps(f(x.a, y.a))) | std::uint32_t(_mm_movemask_ps(f(x.b, y.b))) << 4)
HM_ALWAYS_INLINE Float8 operator+(Float8 x, Float8 y) {
    return HM_EACH_HALF(_mm_add_ps);
}
HM_ALWAYS_INLINE Float8 operator-(Float8 x, Float8 y) {
    return HM_EACH_HALF(_mm_sub_ps);
}
HM_ALWAYS_INLINE Float8 operator*(Float8 x, Float8 y) {
    return HM_EACH_HALF(_mm_mul_ps);
}
HM_ALWAYS_INLINE Float8 operator/(Float8 x, Float8 y) {
    return HM_EACH_HALF(_mm_div_ps);
}
HM_ALWAYS_INLINE Float8 lowest(Float8 x, Float8 y) {
    return HM_EACH_HALF(_mm_min_ps);
}
HM_ALWAYS_INLINE Float8 highest(Float8 x, Float8 y) {
    return HM_EACH_HALF(_mm_max_ps);
}
HM_ALWAYS_INLINE std::uint32_t mask_less(Float8 x, Float8 y) {
    return HM_MASK_OF(_mm_cmplt_ps);
}
HM_ALWAYS_INLINE std::uint32_t mask_less_equal(Float8 x, Float8 y) {
    return HM_MASK_OF(_mm_cmple_ps);
}
HM_ALWAYS_INLINE std::uint32_t mask_differ(Float8 x, Float8 y) {
    return mask_less(x, y) | mask_less(y, x);
}
#undef HM_EACH_HALF
#undef HM_MASK_OF

#else

struct Float8 {
    float v[8];
};
#define HM_EACH_LANE(expression) \
    Float8 r;                    \
    for (int i = 0; i < 8; ++i)  \
        r.v[i] = (expression);   \
    return r
#define HM_EACH_BIT(condition)                        \
    std::uint32_t r = 0;                              \
    for (int i = 0; i < 8; ++i)                       \
        r |= std::uint32_t((condition) ? 1 : 0) << i; \
    return r
HM_ALWAYS_INLINE Float8 load8(const float* p) {
    HM_EACH_LANE(p[i]);
}
HM_ALWAYS_INLINE void store8(float* p, Float8 x) {
    for (int i = 0; i < 8; ++i)
        p[i] = x.v[i];
}
HM_ALWAYS_INLINE Float8 splat8(float x) {
    HM_EACH_LANE(x);
}
HM_ALWAYS_INLINE Float8 operator+(Float8 x, Float8 y) {
    HM_EACH_LANE(x.v[i] + y.v[i]);
}
HM_ALWAYS_INLINE Float8 operator-(Float8 x, Float8 y) {
    HM_EACH_LANE(x.v[i] - y.v[i]);
}
HM_ALWAYS_INLINE Float8 operator*(Float8 x, Float8 y) {
    HM_EACH_LANE(x.v[i] * y.v[i]);
}
HM_ALWAYS_INLINE Float8 operator/(Float8 x, Float8 y) {
    HM_EACH_LANE(x.v[i] / y.v[i]);
}
HM_ALWAYS_INLINE Float8 lowest(Float8 x, Float8 y) {
    HM_EACH_LANE(x.v[i] < y.v[i] ? x.v[i] : y.v[i]);
}
HM_ALWAYS_INLINE Float8 highest(Float8 x, Float8 y) {
    HM_EACH_LANE(x.v[i] > y.v[i] ? x.v[i] : y.v[i]);
}
HM_ALWAYS_INLINE std::uint32_t mask_less(Float8 x, Float8 y) {
    HM_EACH_BIT(x.v[i] < y.v[i]);
}
HM_ALWAYS_INLINE std::uint32_t mask_less_equal(Float8 x, Float8 y) {
    HM_EACH_BIT(x.v[i] <= y.v[i]);
}
HM_ALWAYS_INLINE std::uint32_t mask_differ(Float8 x, Float8 y) {
    HM_EACH_BIT(x.v[i] < y.v[i] || y.v[i] < x.v[i]);
}
#undef HM_EACH_LANE
#undef HM_EACH_BIT

#endif

HM_ALWAYS_INLINE float lowest(float a, float b) {
    return a < b ? a : b;
}
HM_ALWAYS_INLINE float highest(float a, float b) {
    return a > b ? a : b;
}

}  // namespace hm
