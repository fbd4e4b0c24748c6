// A material at one point of a surface: its parameters with the textures applied.
#ifndef HM_SHADING_MATERIAL_POINT_H
#define HM_SHADING_MATERIAL_POINT_H

#include "shading/lang.h"

HM_NAMESPACE_BEGIN

struct MaterialPoint {
    vec3 base_color;        // linear Rec.709
    float metallic;         // 0 to 1
    float roughness;        // perceptual; alpha is its square
    float specular_weight;  // scales the dielectric's F0 and F90
};

// What extensions add.
struct ExtendedPoint {
    vec3 specular_color;  // f0 over that of the index, or f0 itself where `glossy`
    float specular;
    float ior;
    bool glossy;
    float clearcoat;
    float clearcoat_roughness;
    vec3 sheen_color;
    float sheen_roughness;
    float anisotropy;
    vec2 anisotropy_direction;  // in the tangent frame, unit
    float iridescence;
    float iridescence_ior;
    float iridescence_thickness;  // nanometres
    float transmission;
    float diffuse_transmission;
    vec3 diffuse_transmission_color;
};

HM_NAMESPACE_END

#endif
