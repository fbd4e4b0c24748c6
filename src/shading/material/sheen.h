// The sheen lobe of KHR_materials_sheen: the distribution of cloth fibres and its shadowing of
// Estevez and Kulla ("Production Friendly Microfacet Sheen BRDF", 2017). Directions are local.
#ifndef HM_SHADING_MATERIAL_SHEEN_H
#define HM_SHADING_MATERIAL_SHEEN_H

#include "shading/math.h"

HM_NAMESPACE_BEGIN

// Fibres that stand upright to the last have no finite density.
HM_CONST float kMinSheenRoughness = 0.07f;

HM_FN float eval_sheen_d(float cos_h, float alpha) {
    float inverse = 1.0f / alpha;
    float sine = fast_sqrt(saturate(1.0f - cos_h * cos_h));
    return (2.0f + inverse) * pow(max(sine, 1e-8f), inverse) * (0.5f * kInvPi);
}

// The fit of the paper's table 1 at a cosine up to one half; `t` is (1 - alpha)^2.
HM_FN float sheen_curve(float x, float t) {
    float a = 21.5473f + (25.3245f - 21.5473f) * t;
    float b = 3.82987f + (3.32435f - 3.82987f) * t;
    float c = 0.19823f + (0.16801f - 0.19823f) * t;
    float d = -1.97760f + (-1.27393f + 1.97760f) * t;
    float e = -4.32054f + (-4.85967f + 4.32054f) * t;
    return a / (1.0f + b * pow(max(x, 1e-8f), c)) + d * x + e;
}

HM_FN float sheen_lambda(float cosine, float alpha) {
    float t = (1.0f - alpha) * (1.0f - alpha);
    if (cosine < 0.5f) return exp(sheen_curve(cosine, t));
    return exp(2.0f * sheen_curve(0.5f, t) - sheen_curve(1.0f - cosine, t));
}

// f, without colour and cosine.
HM_FN float eval_sheen(vec3 wo, vec3 wi, float roughness) {
    HM_MAY_CONTRACT
    float r = max(roughness, kMinSheenRoughness);
    float alpha = r * r;
    vec3 h = fast_normalize(wo + wi);
    float shadowing = 1.0f / (1.0f + sheen_lambda(wo.z, alpha) + sheen_lambda(wi.z, alpha));
    return eval_sheen_d(h.z, alpha) * shadowing / (4.0f * max(wo.z * wi.z, 1e-7f));
}

HM_NAMESPACE_END

#endif
