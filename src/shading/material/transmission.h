// Light through a boundary of glass: refraction by GGX microfacets (Walter et al., "Microfacet
// Models for Refraction through Rough Surfaces", 2007) into a volume, or straight on through a thin
// wall (KHR_materials_transmission). Values are of basic radiance, L / n^2: it is constant across a
// smooth boundary, so nothing scales it. Directions are local, wo above the surface, wi below.
#ifndef HM_SHADING_MATERIAL_TRANSMISSION_H
#define HM_SHADING_MATERIAL_TRANSMISSION_H

#include "shading/material/fresnel.h"
#include "shading/material/ggx_anisotropic.h"

HM_NAMESPACE_BEGIN

// The refracted direction about a microfacet normal h on wo's side, or 0 under total reflection.
HM_FN vec3 refract_about(vec3 wo, vec3 h, float eta) {
    float cos_o = dot(wo, h);
    float cos_t;
    if (fresnel_dielectric(cos_o, eta, cos_t) >= 1.0f) return vec3(0.0f);
    float inverse = divide(1.0f, eta);
    return h * (cos_o * inverse - cos_t) - wo * inverse;
}

// The microfacet normal that refracts wo to wi.
HM_FN vec3 refraction_normal(vec3 wo, vec3 wi, float eta) {
    vec3 h = fast_normalize(wo + wi * eta);
    return h.z < 0.0f ? -h : h;
}

// Refraction without its Fresnel factor: f cos_i, and the density of sample_visible_normal followed
// by refract_about. cos_d is the cosine of wo to the microfacet normal, for the caller's Fresnel
// factor; 0 where no microfacet refracts so.
HM_FN float eval_refraction(vec3 wo, vec3 wi, vec2 alpha, float eta, HM_OUT(float) pdf,
                            HM_OUT(float) cos_d) {
    HM_MAY_CONTRACT
    vec3 h = refraction_normal(wo, wi, eta);
    float dot_o = dot(wo, h);
    float dot_i = dot(wi, h);
    pdf = 0.0f;
    cos_d = 0.0f;
    if (!(dot_o > 0.0f) || !(dot_i < 0.0f)) return 0.0f;
    cos_d = dot_o;
    float denominator = dot_o + eta * dot_i;
    float jacobian = eta * eta * -dot_i / max(denominator * denominator, 1e-20f);
    float length_o = stretched_length(wo, alpha);
    float length_i = stretched_length(wi, alpha);
    float visible = eval_anisotropic_d(h, alpha) * dot_o * jacobian;
    pdf = visible * 2.0f / (wo.z + length_o);
    // G2 / cos_o, height-correlated.
    float masking = 2.0f * -wi.z / (length_o * -wi.z + length_i * wo.z);
    return visible * masking;
}

HM_NAMESPACE_END

#endif
