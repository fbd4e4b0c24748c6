// Points and normals of surfaces: leaving a surface without hitting it again, and shading normals
// that stay consistent with the geometry.
#ifndef HM_SHADING_GEOMETRY_H
#define HM_SHADING_GEOMETRY_H

#include "shading/math.h"
#include "shading/structs.h"

HM_NAMESPACE_BEGIN

// How far rounding may move a hit off the plane of its triangle, and a traversal's triangle off
// that plane, along the unit normal n (Pharr, Jakob and Humphreys, "Physically Based Rendering",
// 4th edition, 6.8). In units of 2^-24:
// - what scales with the coordinates of p, per axis and in both spaces: interpolation 5,
// transforming
//   the point, the tree's vertices and the ray's origin 4 each, rounding the matrices 2, adding the
//   offset 1;
// - what scales with the triangle, in any direction, because the watertight test (Woop, Benthin and
//   Wald 2013) shears x and y by z: subtraction and shear 4 each for two axes. GPUs get twice that.
// `extent` is the longest side of the triangle along an axis. Nothing here has a unit: a scene may
// be of any size.
HM_CONST float kRoundoff = 1.0f / 16777216.0f;
HM_CONST float kCoordinateError = 20.0f * kRoundoff;
HM_CONST float kExtentError = 16.0f * kRoundoff;

// The largest terms that meet while a point of these absolute coordinates is taken to object space
// and back: what rounding scales with.
HM_FN vec3 transform_magnitude(HM_IN(InstanceData) instance, vec3 p) {
    HM_ROW(mat4x3) w = instance.world_to_object;
    vec3 local = abs(w[0]) * p.x + abs(w[1]) * p.y + abs(w[2]) * p.z + abs(w[3]);
    HM_ROW(mat4x3) m = instance.object_to_world;
    return abs(m[0]) * local.x + abs(m[1]) * local.y + abs(m[2]) * local.z + abs(m[3]);
}

// The longest side of a triangle along an axis.
HM_FN float triangle_extent(vec3 edge1, vec3 edge2) {
    return max_component(max(max(abs(edge1), abs(edge2)), abs(edge2 - edge1)));
}

HM_FN float hit_error(vec3 coordinates, float extent, vec3 n) {
    return kCoordinateError * dot(abs(n), coordinates) + kExtentError * extent;
}

// How far from its end a shadow ray, of this length and direction, may meet a surface at its end:
// the error of hits and that of the vertices relative to the ray's origin, along the ray. Rays that
// graze the surface, or whose end lies on several surfaces (n zero), get that of a cosine of 1/64;
// of the length it is less than 1e-4 then.
HM_CONST float kLengthError = 16.0f * kRoundoff;
HM_CONST float kLeastEndCosine = 1.0f / 64.0f;

HM_FN float ray_end_error(float surface_error, vec3 n, vec3 direction, float distance) {
    return (surface_error + kLengthError * distance) / max(abs(dot(n, direction)), kLeastEndCosine);
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
