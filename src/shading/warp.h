// From the unit square to directions and shapes, with their densities.
#ifndef HM_SHADING_WARP_H
#define HM_SHADING_WARP_H

#include "shading/math.h"

HM_NAMESPACE_BEGIN

// Uniform on the unit disk.
HM_FN vec2 sample_disk(float u, float v) {
    vec2 direction = cos_sin_2pi(v);
    return sqrt(u) * direction;
}

// Cosine-weighted on the hemisphere around +z (Malley).
HM_FN vec3 sample_cosine_hemisphere(float u, float v) {
    vec2 disk = sample_disk(u, v);
    return vec3(disk.x, disk.y, sqrt(max(1.0f - u, 0.0f)));
}

HM_FN float pdf_cosine_hemisphere(float cos_theta) {
    return max(cos_theta, 0.0f) * kInvPi;
}

// Uniform on the hemisphere around +z; the density is 1 / (2 pi).
HM_FN vec3 sample_uniform_hemisphere(float u, float v) {
    float sine = sqrt(max(1.0f - u * u, 0.0f));
    vec2 direction = cos_sin_2pi(v);
    return vec3(sine * direction.x, sine * direction.y, u);
}

// Barycentric weights of the second and third vertex, uniform over the triangle (Heitz, "A
// Low-Distortion Map Between Triangle and Square", 2019).
HM_FN vec2 sample_triangle(float u, float v) {
    if (v > u) {
        float half_u = 0.5f * u;
        return vec2(half_u, v - half_u);
    }
    float half_v = 0.5f * v;
    return vec2(u - half_v, half_v);
}

HM_NAMESPACE_END

#endif
