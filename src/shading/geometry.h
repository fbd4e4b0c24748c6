// Points and normals of surfaces: leaving a surface without hitting it again, and shading normals
// that stay consistent with the geometry.
#ifndef HM_SHADING_GEOMETRY_H
#define HM_SHADING_GEOMETRY_H

#include "shading/lang.h"

HM_NAMESPACE_BEGIN

HM_FN float offset_coordinate(float p, float n) {
    // Near the origin the spacing of floats is finer than the rounding error of the transform: move
    // by a fixed 2^-16 there, otherwise by up to 256 units in the last place.
    if (abs(p) < 1.0f / 32.0f) return p + n * (1.0f / 65536.0f);
    int steps = int(256.0f * n);
    uint bits = float_bits(p);
    return bits_float(p < 0.0f ? bits - uint(steps) : bits + uint(steps));
}

// Moves a point off its surface along the unit normal n (Wächter and Binder, "A Fast and Robust
// Method for Avoiding Self-Intersection", Ray Tracing Gems 2019).
HM_FN vec3 offset_ray_origin(vec3 p, vec3 n) {
    return vec3(offset_coordinate(p.x, n.x), offset_coordinate(p.y, n.y),
                offset_coordinate(p.z, n.z));
}

// The mirror direction of wo about the bent normal rises at least this far over the surface (sine).
HM_CONST float kMirrorClearance = 1e-3f;

// Bends the shading normal ns, both on wo's side of the surface, until the mirror direction of wo
// clears the geometric normal ng: the mirror direction is moved onto the horizon, and the half
// vector with wo is the new normal (as Keller et al., "The Iray Light Transport Simulation and
// Rendering System", 2017). Reflecting ns instead leaves black rims.
HM_FN vec3 bend_shading_normal(vec3 ns, vec3 ng, vec3 wo) {
    vec3 mirrored = 2.0f * dot(wo, ns) * ns - wo;
    float height = dot(mirrored, ng) - kMirrorClearance;
    if (height >= 0.0f) return ns;
    vec3 lifted = normalize(mirrored - ng * height);
    return normalize(wo + lifted);
}

HM_NAMESPACE_END

#endif
