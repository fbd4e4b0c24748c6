// Small functions the standard libraries of the two languages lack or make too imprecise: GLSL
// promises sin, cos and atan only to about 1e-3, so these are polynomials (coefficients: Moshier,
// Cephes single precision) that agree on every device.
#ifndef HM_SHADING_MATH_H
#define HM_SHADING_MATH_H

#include "shading/lang.h"

HM_NAMESPACE_BEGIN

HM_CONST float kPi = 3.14159265358979f;
HM_CONST float kInvPi = 0.318309886183791f;
HM_CONST float kInfinity = 1e30f;  // farther than anything in a scene

// Rec.709 luminance of linear radiance.
HM_FN float luminance(vec3 c) {
    HM_MAY_CONTRACT
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

HM_FN float max_component(vec3 c) {
    return max(c.x, max(c.y, c.z));
}

// Neither infinite nor NaN.
HM_FN bool is_finite_color(vec3 c) {
    vec3 size = abs(c);
    return size.x <= 3.4e38f && size.y <= 3.4e38f && size.z <= 3.4e38f;
}

HM_FN float saturate(float x) {
    return clamp(x, 0.0f, 1.0f);
}

HM_FN float pow5(float x) {
    float x2 = x * x;
    return x2 * x2 * x;
}

// Uniform in [0, 1): the upper 24 bits.
HM_FN float unit_float(uint x) {
    return float(x >> 8u) * 5.9604644775390625e-8f;
}

// (cos, sin) of 2 pi u for u in [0, 1]. Absolute error below 2e-7.
HM_FN vec2 cos_sin_2pi(float u) {
    float quarter = floor(u * 4.0f + 0.5f);
    float x = (u * 4.0f - quarter) * 1.57079632679490f;
    float z = x * x;
    float s = x + x * z * (-1.6666654611e-1f + z * (8.3321608736e-3f + z * -1.9515295891e-4f));
    float c =
        1.0f - 0.5f * z +
        z * z * (4.166664568298827e-2f + z * (-1.388731625493765e-3f + z * 2.443315711809948e-5f));
    uint q = uint(quarter) & 3u;
    bool swapped = (q & 1u) != 0u;
    float cos_abs = swapped ? s : c;
    float sin_abs = swapped ? c : s;
    float cos_sign = (q == 1u || q == 2u) ? -1.0f : 1.0f;
    float sin_sign = q >= 2u ? -1.0f : 1.0f;
    return vec2(cos_abs * cos_sign, sin_abs * sin_sign);
}

// atan2(y, x) / 2 pi in (-0.5, 0.5]. Absolute error below 1e-7; (0, 0) gives 0.
HM_FN float atan2_over_2pi(float y, float x) {
    float ax = abs(x);
    float ay = abs(y);
    float t = min(ax, ay) / max(max(ax, ay), 1e-37f);
    bool upper = t > 0.41421356237f;  // tan(pi/8)
    float w = upper ? (t - 1.0f) / (t + 1.0f) : t;
    float z = w * w;
    float a = w + w * z *
                      (-3.33329491539e-1f +
                       z * (1.99777106478e-1f + z * (-1.38776856032e-1f + z * 8.05374449538e-2f)));
    a = a * (0.5f * kInvPi) + (upper ? 0.125f : 0.0f);
    a = ay > ax ? 0.25f - a : a;
    a = x < 0.0f ? 0.5f - a : a;
    return y < 0.0f ? -a : a;
}

// The power heuristic with exponent 2 for a sample drawn with pdf `own`, against `other`
// (Veach 1997). A zero `own` gives 0; `own` must be finite, `other` may be infinite.
HM_FN float mis_weight(float own, float other) {
    HM_MAY_CONTRACT
    if (!(own > 0.0f)) return 0.0f;
    float ratio = other / own;
    return 1.0f / (1.0f + ratio * ratio);
}

HM_NAMESPACE_END

#endif
