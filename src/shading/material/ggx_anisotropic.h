// GGX with a roughness along x and another along y (Burley 2012; Heitz 2014 for masking), with
// sampling of visible normals: bounded for reflection (Eto and Tokuyoshi 2023), whole spherical
// caps for transmission (Dupuy and Benyoub 2023). Directions are local, z along the normal.
#ifndef HM_SHADING_MATERIAL_GGX_ANISOTROPIC_H
#define HM_SHADING_MATERIAL_GGX_ANISOTROPIC_H

#include "shading/math.h"

HM_NAMESPACE_BEGIN

HM_FN float eval_anisotropic_d(vec3 h, vec2 alpha) {
    HM_MAY_CONTRACT
    float x = h.x / alpha.x;
    float y = h.y / alpha.y;
    float t = x * x + y * y + h.z * h.z;
    return kInvPi / (alpha.x * alpha.y * t * t);
}

// Smith's stretched length: lambda(w) is (length / |w.z| - 1) / 2.
HM_FN float stretched_length(vec3 w, vec2 alpha) {
    HM_MAY_CONTRACT
    float x = w.x * alpha.x;
    float y = w.y * alpha.y;
    return fast_sqrt(x * x + y * y + w.z * w.z);
}

// Height-correlated masking-shadowing over 4 cos_o cos_i, of the directions' stretched lengths.
HM_FN float eval_smith_v(float cos_o, float length_o, float cos_i, float length_i) {
    HM_MAY_CONTRACT
    return 0.5f / (cos_i * length_o + cos_o * length_i);
}

HM_FN float anisotropic_cap_scale(vec3 wo, float sine, vec2 alpha) {
    float a = min(min(alpha.x, alpha.y), 1.0f);
    float s = 1.0f + sine;
    float a2 = a * a;
    float s2 = s * s;
    return divide((1.0f - a2) * s2, s2 + a2 * wo.z * wo.z);
}

// A normal visible from wo. `bound` is where the spherical cap ends: 1 for all visible normals.
HM_FN vec3 sample_visible_normal(vec3 wo, vec2 alpha, float bound, float u, float v) {
    vec3 wo_std = normalize(vec3(wo.x * alpha.x, wo.y * alpha.y, wo.z));
    float lower = bound * wo_std.z;
    float z = (1.0f - u) * (1.0f + lower) - lower;
    float sin_theta = sqrt(saturate(1.0f - z * z));
    vec2 phi = cos_sin_2pi(v);
    vec3 m = vec3(sin_theta * phi.x + wo_std.x, sin_theta * phi.y + wo_std.y, z + wo_std.z);
    return normalize(vec3(m.x * alpha.x, m.y * alpha.y, m.z));
}

// The mirrored direction; may point below the surface, where it carries nothing.
HM_FN vec3 sample_anisotropic_reflection(vec3 wo, vec2 alpha, float u, float v) {
    float sine = sqrt(wo.x * wo.x + wo.y * wo.y);
    float bound = anisotropic_cap_scale(wo, sine, alpha);
    vec3 m = sample_visible_normal(wo, alpha, bound, u, v);
    return 2.0f * dot(wo, m) * m - wo;
}

// Its solid-angle density over the density of normals at the half vector.
HM_FN float anisotropic_reflection_pdf_scale(vec3 wo, vec2 alpha) {
    HM_MAY_CONTRACT
    float sine = fast_sqrt(wo.x * wo.x + wo.y * wo.y);
    return 0.5f / (anisotropic_cap_scale(wo, sine, alpha) * wo.z + stretched_length(wo, alpha));
}

HM_NAMESPACE_END

#endif
