// Parity of the arithmetic that decides branches of paths (shading/exact.glsl): the same bits.
#include "gpu/case.h"

HM_CASES_BEGIN(1, 14)

// Of any magnitude that a scene may have.
HM_FN float case_size(uint index, uint which) {
    uint exponent = 127u - 20u + case_bits(index, which + 100u) % 40u;
    return bits_float((case_bits(index, which) & 0x007fffffu) | (exponent << 23u));
}

// Lengths of vectors that are nearly normalised. There quotients and roots lie close to the middle
// between two floats, where it is hardest to round right.
HM_FN float case_near_one(uint index, uint which) {
    return bits_float(0x3f800000u - 64u + case_bits(index, which) % 128u);
}

HM_FN void run_case(uint index, HM_OUT(CaseResult) result) {
    float u = case_unit(index, 0u);
    float a = case_size(index, 1u);
    float b = case_size(index, 2u);
    float one = case_near_one(index, 3u);
    vec3 v = case_direction(index, 4u);
    vec3 w = case_direction(index, 5u);
    result.values[0] = u;
    result.choices[0] = float_bits(divide(a, b));
    result.choices[1] = float_bits(divide(-1.0f, b));
    result.choices[2] = float_bits(divide(a, one));
    result.choices[3] = float_bits(sqrt(a));
    result.choices[4] = float_bits(sqrt(u));
    result.choices[5] = float_bits(sqrt(one));
    result.choices[6] = float_bits(inversesqrt(a));
    result.choices[7] = float_bits(inversesqrt(one));
    result.choices[8] = float_bits(dot(v, w));
    result.choices[9] = float_bits(cross(v, w).y);
    result.choices[10] = float_bits(normalize(v * a).z);
    // Expressions that a device might contract.
    result.choices[11] = float_bits(a * u + b);
    result.choices[12] = float_bits(v.x * w.y - v.y * w.x);
    vec3 sum = v * a + w;
    result.choices[13] = float_bits(sum.x);
}

HM_CASES_END
