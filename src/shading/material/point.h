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

HM_NAMESPACE_END

#endif
