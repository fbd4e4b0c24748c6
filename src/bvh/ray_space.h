// Per-ray data that the box test and the triangle test precompute for one space (world space or a
// mesh's object space). The error bounds of the planes follow Woop, Benthin and Wald, "Watertight
// Ray/Triangle Intersection", JCGT 2013, and Ize, "Robust BVH Ray Traversal", JCGT 2013.
#pragma once

#include "bvh/simd.h"
#include "bvh/view.h"

namespace hm {

// Data for the box test, as vectors that the traversal loop keeps in registers. The ray crosses
// near planes at (plane - near_origin) * inverse and far planes at
// (plane - far_origin) * inverse * kFarScale. The origins are moved apart, and far distances
// scaled up, by the rounding error of the triangle test and the box test, so the box test never
// culls a triangle that the triangle test would hit.
struct BoxRay {
    Float8 near_origin[3], far_origin[3], inverse[3];
    std::uint32_t near_plane[3];  // index into BvhNode::bounds; the far plane's is that ^ 1
};

// Data for the triangle test, and the box test's data as scalars.
struct TriangleRay {
    float origin[3];
    float near_origin[3], inverse[3];
    // Axis kz is the one with the direction's largest component; x and y are sheared along it.
    std::uint32_t kx, ky, kz;
    float shear_x, shear_y, scale_z;
};

struct RaySpace {
    BoxRay box;
    TriangleRay triangle;
};

// 1 + 2 gamma(3) is 1 + 3 * 2^-23; one more 2^-23 covers the rounding of the multiplication by it.
inline constexpr float kFarScale = 1 + 4 * 0x1p-23f;

HM_ALWAYS_INLINE float magnitude(float x) {
    return x < 0 ? -x : x;
}

HM_ALWAYS_INLINE RaySpace make_ray_space(const float* origin, const float* direction,
                                         const BvhBounds& bounds) {
    RaySpace space;
    TriangleRay& s = space.triangle;
    const float ax = magnitude(direction[0]);
    const float ay = magnitude(direction[1]);
    const float az = magnitude(direction[2]);
    s.kz = ax > ay ? (ax > az ? 0u : 2u) : (ay > az ? 1u : 2u);
    s.kx = s.kz == 2 ? 0u : s.kz + 1;
    s.ky = s.kx == 2 ? 0u : s.kx + 1;
    // The rounding error of a sheared coordinate is at most 2^-24 * (2 |x| + 5 |z|), where x and z
    // are the distances from the origin to the vertex along the axes; the factor 8 also covers the
    // rounding of this bound itself.
    constexpr float kShearError = 8 * 0x1p-24f;
    // Finite, so that 0 * inverse is not NaN. Boxes are padded, so a zero direction component clips
    // the interval no tighter than this times the padding, which is still beyond every t.
    constexpr float kMaxInverse = 1e38f;
    float reach[3];
    for (int a = 0; a < 3; ++a)
        reach[a] =
            highest(magnitude(bounds.lo[a] - origin[a]), magnitude(bounds.hi[a] - origin[a]));
    for (int a = 0; a < 3; ++a) {
        // The second term is one ulp of the origin, so that adding the padding does change it.
        const float padding =
            kShearError * (reach[a] + reach[s.kz]) + 0x1p-23f * magnitude(origin[a]);
        const bool negative = direction[a] < 0;
        const float inverse = magnitude(direction[a]) * kMaxInverse > 1
                                  ? 1.0f / direction[a]
                                  : (negative ? -kMaxInverse : kMaxInverse);
        s.origin[a] = origin[a];
        s.near_origin[a] = negative ? origin[a] - padding : origin[a] + padding;
        s.inverse[a] = inverse;
        space.box.near_origin[a] = splat8(s.near_origin[a]);
        space.box.far_origin[a] = splat8(negative ? origin[a] + padding : origin[a] - padding);
        space.box.inverse[a] = splat8(inverse);
        space.box.near_plane[a] = 2 * std::uint32_t(a) + (negative ? 1u : 0u);
    }
    s.scale_z = s.inverse[s.kz];
    s.shear_x = direction[s.kx] * s.scale_z;
    s.shear_y = direction[s.ky] * s.scale_z;
    return space;
}

}  // namespace hm
