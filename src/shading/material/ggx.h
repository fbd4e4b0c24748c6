// The isotropic GGX microfacet distribution (glTF 2.0 Appendix B.3) with height-correlated Smith
// masking (Heitz 2014), and bounded sampling of its visible normals (Eto and Tokuyoshi, "Bounded
// VNDF Sampling for Smith-GGX Reflections", 2023). Directions are local, z along the normal.
#ifndef HM_SHADING_MATERIAL_GGX_H
#define HM_SHADING_MATERIAL_GGX_H

#include "shading/math.h"

HM_NAMESPACE_BEGIN

// Density of microfacet normals. The form (hx^2 + hy^2) / a^2 + hz^2 has no cancellation; the usual
// nh^2 (a^2 - 1) + 1 loses all digits near the peak of a smooth surface.
HM_FN float eval_ggx_d(vec3 h, float alpha) {
    HM_MAY_CONTRACT
    float inv_alpha = 1.0f / alpha;
    float x = h.x * inv_alpha;
    float y = h.y * inv_alpha;
    float t = x * x + y * y + h.z * h.z;
    return kInvPi * inv_alpha * inv_alpha / (t * t);
}

// Masking-shadowing over 4 cos_o cos_i. Both cosines are positive.
HM_FN float eval_ggx_v(float cos_o, float cos_i, float alpha) {
    HM_MAY_CONTRACT
    float a2 = alpha * alpha;
    float lambda_o = cos_i * fast_sqrt(a2 + (1.0f - a2) * cos_o * cos_o);
    float lambda_i = cos_o * fast_sqrt(a2 + (1.0f - a2) * cos_i * cos_i);
    return 0.5f / (lambda_o + lambda_i);
}

// The lower end of the spherical cap that bounded sampling draws from, for an upper-hemisphere wo
// and its sine.
HM_FN float ggx_cap_scale(vec3 wo, float sine, float alpha) {
    float s = 1.0f + sine;
    float a2 = alpha * alpha;
    float s2 = s * s;
    return divide((1.0f - a2) * s2, s2 + a2 * wo.z * wo.z);
}

// The mirrored direction wi for a visible normal. wi.z may be negative: such a sample carries
// nothing.
HM_FN vec3 sample_ggx_reflection(vec3 wo, float alpha, float u, float v) {
    vec3 wo_std = normalize(vec3(wo.x * alpha, wo.y * alpha, wo.z));
    float sine = sqrt(wo.x * wo.x + wo.y * wo.y);
    float lower = ggx_cap_scale(wo, sine, alpha) * wo_std.z;
    float z = (1.0f - u) * (1.0f + lower) - lower;
    float sin_theta = sqrt(saturate(1.0f - z * z));
    vec2 phi = cos_sin_2pi(v);
    vec3 m_std = vec3(sin_theta * phi.x + wo_std.x, sin_theta * phi.y + wo_std.y, z + wo_std.z);
    vec3 m = normalize(vec3(m_std.x * alpha, m_std.y * alpha, m_std.z));
    return 2.0f * dot(wo, m) * m - wo;
}

// The solid-angle density of sample_ggx_reflection over that of microfacet normals at the half
// vector.
HM_FN float ggx_reflection_pdf_scale(vec3 wo, float alpha) {
    HM_MAY_CONTRACT
    float x = wo.x * alpha;
    float y = wo.y * alpha;
    float t = fast_sqrt(x * x + y * y + wo.z * wo.z);
    float sine = fast_sqrt(wo.x * wo.x + wo.y * wo.y);
    return 0.5f / (ggx_cap_scale(wo, sine, alpha) * wo.z + t);
}

HM_NAMESPACE_END

#endif
