// The watertight ray/triangle test of Woop, Benthin and Wald (JCGT 2013) for the eight triangles of
// a packet. A ray through a shared edge or vertex hits at least one of the adjacent triangles.
#pragma once

#include "bvh/ray_space.h"

namespace hm {

struct alignas(32) PacketHits {
    float t[kBvhWidth], u[kBvhWidth], v[kBvhWidth];
};

// One lane in double precision, where the products in the edge functions, and hence their signs,
// are exact. Fallback for edge functions that are zero or out of range in single precision, and for
// hits close to the ray origin.
__attribute__((noinline)) static inline bool intersect_lane_double(const BvhPacket& packet,
                                                                   std::uint32_t lane,
                                                                   const TriangleRay& ray,
                                                                   float t_max, PacketHits& hits) {
    double x[3], y[3], z[3];
    for (int i = 0; i < 3; ++i) {
        const auto& p = packet.position[i];
        const float pz = p[ray.kz][lane] - ray.origin[ray.kz];
        const float px = p[ray.kx][lane] - ray.origin[ray.kx];
        const float py = p[ray.ky][lane] - ray.origin[ray.ky];
        const float sheared_x = px - ray.shear_x * pz;
        const float sheared_y = py - ray.shear_y * pz;
        x[i] = double(sheared_x);
        y[i] = double(sheared_y);
        z[i] = double(pz);
    }
    const double a = x[2] * y[1] - y[2] * x[1];
    const double b = x[0] * y[2] - y[0] * x[2];
    const double c = x[1] * y[0] - y[1] * x[0];
    if ((a < 0 || b < 0 || c < 0) && (a > 0 || b > 0 || c > 0)) return false;
    const double sum = a + b + c;
    if (!(sum < 0 || sum > 0)) return false;
    const double t =
        double(ray.scale_z) * (z[0] + (b / sum) * (z[1] - z[0]) + (c / sum) * (z[2] - z[0]));
    hits.t[lane] = float(t);
    hits.u[lane] = float(b / sum);
    hits.v[lane] = float(c / sum);
    return hits.t[lane] > 0 && hits.t[lane] <= t_max;
}

// Returns a bit per lane that is hit with 0 < t <= t_max.
HM_ALWAYS_INLINE std::uint32_t intersect_packet(const BvhPacket& packet, const TriangleRay& ray,
                                                float t_max, PacketHits& hits) {
    const Float8 ox = splat8(ray.origin[ray.kx]);
    const Float8 oy = splat8(ray.origin[ray.ky]);
    const Float8 oz = splat8(ray.origin[ray.kz]);
    const Float8 shear_x = splat8(ray.shear_x);
    const Float8 shear_y = splat8(ray.shear_y);
    const Float8 az = load8(packet.position[0][ray.kz]) - oz;
    const Float8 bz = load8(packet.position[1][ray.kz]) - oz;
    const Float8 cz = load8(packet.position[2][ray.kz]) - oz;
    const Float8 ax = (load8(packet.position[0][ray.kx]) - ox) - shear_x * az;
    const Float8 bx = (load8(packet.position[1][ray.kx]) - ox) - shear_x * bz;
    const Float8 cx = (load8(packet.position[2][ray.kx]) - ox) - shear_x * cz;
    const Float8 ay = (load8(packet.position[0][ray.ky]) - oy) - shear_y * az;
    const Float8 by = (load8(packet.position[1][ray.ky]) - oy) - shear_y * bz;
    const Float8 cy = (load8(packet.position[2][ray.ky]) - oy) - shear_y * cz;

    // Edge functions: twice the projected areas opposite to each vertex. Rounding is monotone, so a
    // nonzero result has the correct sign; two opposite signs are a miss whatever the third is.
    const Float8 a = cx * by - cy * bx;
    const Float8 b = ax * cy - ay * cx;
    const Float8 c = bx * ay - by * ax;
    const Float8 zero = splat8(0);
    const std::uint32_t missed =
        mask_less(lowest(lowest(a, b), c), zero) & mask_less(zero, highest(highest(a, b), c));
    const std::uint32_t candidates = packet.used & ~missed;
    if (candidates == 0) return 0;

    const Float8 sum = a + b + c;
    const Float8 inverse = splat8(1) / sum;
    const Float8 u = b * inverse;
    const Float8 v = c * inverse;
    // In this form, triangles in a common plane perpendicular to axis kz get exactly the same t.
    const Float8 depth = az + (u * (bz - az) + v * (cz - az));
    const Float8 t = splat8(ray.scale_z) * depth;
    // Outside these limits 1 / sum or an edge function may be denormal or overflow.
    const Float8 size = highest(sum, zero - sum);
    // For a narrow triangle the rounding error of the depth grows with the triangle's length and
    // exceeds the offset between the origin of a ray that leaves the triangle and the triangle.
    const Float8 length = highest(highest(az, bz), cz) - lowest(lowest(az, bz), cz);
    const Float8 near = splat8(0x1p-12f) * length;
    const std::uint32_t sure = mask_differ(a, zero) & mask_differ(b, zero) & mask_differ(c, zero) &
                               mask_less(splat8(1e-36f), size) & mask_less(size, splat8(1e36f)) &
                               mask_less(near, highest(depth, zero - depth));
    std::uint32_t hit = candidates & sure & mask_less(zero, t) & mask_less_equal(t, splat8(t_max));
    store8(hits.t, t);
    store8(hits.u, u);
    store8(hits.v, v);
    for (std::uint32_t rest = candidates & ~sure; rest != 0; rest &= rest - 1) {
        const std::uint32_t lane = std::uint32_t(__builtin_ctz(rest));
        if (intersect_lane_double(packet, lane, ray, t_max, hits)) hit |= 1u << lane;
    }
    return hit;
}

// Entry distance of the ray into one triangle's bounding box, computed as for a node's child.
// Rounding is monotone, so no enclosing box has a larger entry distance.
HM_ALWAYS_INLINE float triangle_entry(const BvhPacket& packet, std::uint32_t lane,
                                      const TriangleRay& ray) {
    float entry = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const float a = packet.position[0][axis][lane];
        const float b = packet.position[1][axis][lane];
        const float c = packet.position[2][axis][lane];
        const float plane =
            ray.inverse[axis] < 0 ? highest(highest(a, b), c) : lowest(lowest(a, b), c);
        entry = highest((plane - ray.near_origin[axis]) * ray.inverse[axis], entry);
    }
    return entry;
}

}  // namespace hm
