// Fresnel reflectance of smooth boundaries between dielectrics.
#ifndef HM_SHADING_MATERIAL_FRESNEL_H
#define HM_SHADING_MATERIAL_FRESNEL_H

#include "shading/math.h"

HM_NAMESPACE_BEGIN

// Reflectance at normal incidence between media of relative index eta (either way round).
HM_FN float normal_reflectance(float eta) {
    float r = divide(eta - 1.0f, eta + 1.0f);
    return r * r;
}

// Reflectance of unpolarised light (Born and Wolf, 1.5.2). `eta` is the index of the medium beyond
// over that of the medium of the incident ray; `cos_t` the cosine beyond, 0 under total internal
// reflection.
HM_FN float fresnel_dielectric(float cos_i, float eta, HM_OUT(float) cos_t) {
    float sin2_t = divide(max(1.0f - cos_i * cos_i, 0.0f), eta * eta);
    cos_t = 0.0f;
    if (sin2_t >= 1.0f) return 1.0f;
    cos_t = sqrt(1.0f - sin2_t);
    float perpendicular = divide(cos_i - eta * cos_t, cos_i + eta * cos_t);
    float parallel = divide(eta * cos_i - cos_t, eta * cos_i + cos_t);
    return 0.5f * (perpendicular * perpendicular + parallel * parallel);
}

// A boundary's reflectance given its ends f0 and f90, following the exact curve of a dielectric
// instead of Schlick's: f0 at normal incidence, f90 at grazing angles and under total reflection.
HM_FN vec3 fresnel_between(vec3 f0, vec3 f90, float reflectance, float eta) {
    HM_MAY_CONTRACT
    float r0 = normal_reflectance(eta);
    float t = saturate((reflectance - r0) / max(1.0f - r0, 1e-6f));
    return f0 + (f90 - f0) * t;
}

HM_NAMESPACE_END

#endif
