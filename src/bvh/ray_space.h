// A ray prepared for one space (the world or a mesh's own): what the box test and the triangle test
// need per ray. The planes' errors follow Woop, Benthin and Wald, "Watertight Ray/Triangle
// Intersection", JCGT 2013, and Ize, "Robust BVH Ray Traversal", JCGT 2013.
#pragma once

#include "bvh/simd.h"
#include "bvh/view.h"

namespace hm {

// The box test's part, in vectors that the traversal's loop keeps in registers. Near planes are met
// at (plane - near_origin) * inverse, far ones at (plane - far_origin) * inverse * kFarScale. The
// origins are moved apart, and far distances lengthened, by as much as rounding can move a triangle
// in the triangle test or a plane in the box test: no box hides a triangle that the triangle test
// would hit.
struct BoxRay {
    Float8 near_origin[3], far_origin[3], inverse[3];
    std::uint32_t near_plane[3];  // index into BvhNode::bounds; the far plane's is that ^ 1
};

// The triangle test's part, and the box test's as plain numbers.
struct TriangleRay {
    float origin[3];
    float near_origin[3], inverse[3];
    // Axis kz is the direction's largest; x and y are sheared along it.
    std::uint32_t kx, ky, kz;
    float shear_x, shear_y, scale_z;
};

struct RaySpace {
    BoxRay box;
    TriangleRay triangle;
};

// 1 + 2 gamma(3) is 1 + 3 * 2^-23; one more for multiplying it in.
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
    // A sheared coordinate is off by at most 2^-24 (2 |x| + 5 |z|), x and z being distances from
    // the origin to the vertex along the axes; 8 covers this bound's own rounding.
    constexpr float kShearError = 8 * 0x1p-24f;
    // Keeps 0 * inverse a number. Boxes are padded, so a direction of zero leaves at most this
    // times the padding: still beyond every t.
    constexpr float kMaxInverse = 1e38f;
    float reach[3];
    for (int a = 0; a < 3; ++a)
        reach[a] =
            highest(magnitude(bounds.lo[a] - origin[a]), magnitude(bounds.hi[a] - origin[a]));
    for (int a = 0; a < 3; ++a) {
        // The second term is one unit in the last place of the origin, so the sum does differ.
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
