// BVH traversal for the closest hit or any hit of a ray, nearest child first. Header only: it is
// compiled in one translation unit per instruction set, so nothing here may emit a weak symbol.
//
// The result does not depend on the tree or the traversal order: ties in distance go to the lower
// (instance, geometry, primitive), a box entered exactly at the best distance is still visited, and
// a hit's t is never less than the box test's entry distance into its triangle's bounding box.
//
// accept(const Hit&) -> bool is called for hits on non-opaque geometries, in any order and at most
// once per triangle, including hits that turn out not to be the closest.
#pragma once

#include "bvh/triangle.h"

namespace hm {

// Traversal state. Stack entries are (bits of the entry distance << 32) | child: distances are not
// negative, so entries sort as integers.
struct BvhWalk {
    float best_t;
    float best_u, best_v;
    std::uint32_t best_slot;      // 8 * packet + lane
    std::uint32_t best_instance;  // index into BvhView::instances; kBvhEmpty: world space
    std::uint32_t instance;       // the same for the current position of the traversal
    float instance_entry;
};

inline constexpr std::uint32_t kBvhNoSlot = 0xffffffffu;
inline constexpr std::uint32_t kBvhLeaveInstance = 0xffffffffu;  // stack marker, at distance 0

HM_ALWAYS_INLINE BvhTriangleId triangle_id(const BvhView& view, std::uint32_t instance,
                                           std::uint32_t slot) {
    BvhTriangleId id = view.ids[slot];
    if (instance != kBvhEmpty) id.instance = view.instances[instance].instance;
    return id;
}

HM_ALWAYS_INLINE bool lower_id(const BvhTriangleId& a, const BvhTriangleId& b) {
    if (a.instance != b.instance) return a.instance < b.instance;
    if (a.geometry != b.geometry) return a.geometry < b.geometry;
    return a.primitive < b.primitive;
}

// Updates the best hit with the packet's hits. Returns true if traversal can stop (any hit).
template <bool kAny, class Accept>
HM_ALWAYS_INLINE bool visit_packet(const BvhView& view, std::uint32_t index, const TriangleRay& ray,
                                   BvhWalk& walk, Accept& accept) {
    const BvhPacket& packet = view.packets[index];
    PacketHits hits;
    std::uint32_t hit = intersect_packet(packet, ray, walk.best_t, hits);
    for (; hit != 0; hit &= hit - 1) {
        const std::uint32_t lane = std::uint32_t(__builtin_ctz(hit));
        const float t =
            highest(highest(hits.t[lane], triangle_entry(packet, lane, ray)), walk.instance_entry);
        if (!(t <= walk.best_t)) continue;
        const std::uint32_t slot = kBvhWidth * index + lane;
        if (t == walk.best_t && (walk.best_slot == kBvhNoSlot ||
                                 lower_id(triangle_id(view, walk.best_instance, walk.best_slot),
                                          triangle_id(view, walk.instance, slot))))
            continue;
        if ((packet.non_opaque >> lane & 1) != 0) {
            const BvhTriangleId id = triangle_id(view, walk.instance, slot);
            const Hit candidate{t,           hits.u[lane], hits.v[lane],
                                id.instance, id.geometry,  id.primitive};
            if (!accept(candidate)) continue;
        }
        if constexpr (kAny) return true;
        walk.best_t = t;
        walk.best_u = hits.u[lane];
        walk.best_v = hits.v[lane];
        walk.best_slot = slot;
        walk.best_instance = walk.instance;
    }
    return false;
}

// Returns a bit per child that the ray enters at or before `best_t`; `entry` gets the distances.
HM_ALWAYS_INLINE std::uint32_t enter_children(const BvhNode& node, const BoxRay& ray, float best_t,
                                              Float8& entry) {
    const auto near_at = [&](std::uint32_t a) {
        return (load8(node.bounds[ray.near_plane[a]]) - ray.near_origin[a]) * ray.inverse[a];
    };
    const auto far_at = [&](std::uint32_t a) {
        return (load8(node.bounds[ray.near_plane[a] ^ 1]) - ray.far_origin[a]) * ray.inverse[a];
    };
    entry = highest(highest(near_at(0), near_at(1)), highest(near_at(2), splat8(0)));
    const Float8 exit = lowest(lowest(far_at(0), far_at(1)), far_at(2)) * splat8(kFarScale);
    return mask_less_equal(entry, lowest(exit, splat8(best_t)));
}

HM_ALWAYS_INLINE void prefetch_child(const BvhView& view, std::uint64_t entry) {
    const std::uint32_t child = std::uint32_t(entry);
    const std::uint32_t index = child & ~kBvhKindMask;
    const char* at = (child & kBvhKindMask) == kBvhInner
                         ? reinterpret_cast<const char*>(view.nodes + index)
                         : reinterpret_cast<const char*>(view.packets + index);
    for (int line = 0; line < 4; ++line)
        __builtin_prefetch(at + 64 * line);
}

// Insertion sort, nearest last.
HM_ALWAYS_INLINE void sort_entries(std::uint64_t* first, std::uint64_t* last) {
    for (std::uint64_t* i = first + 1; i < last; ++i) {
        const std::uint64_t moved = *i;
        std::uint64_t* j = i;
        for (; j > first && j[-1] < moved; --j)
            *j = j[-1];
        *j = moved;
    }
}

// Pushes the children in `mask` (at least one) except the nearest, which it returns. With kAny,
// three or more children are not sorted.
template <bool kAny>
HM_ALWAYS_INLINE std::uint64_t push_children(const BvhView& view, const BvhNode& node,
                                             std::uint32_t mask, Float8 entry, std::uint64_t* stack,
                                             std::uint32_t& height) {
    alignas(32) float distance[kBvhWidth];
    store8(distance, entry);
    const auto take = [&] {
        const std::uint32_t lane = std::uint32_t(__builtin_ctz(mask));
        mask &= mask - 1;
        const std::uint32_t bits = __builtin_bit_cast(std::uint32_t, distance[lane]);
        return std::uint64_t(bits) << 32 | node.child[lane];
    };
    const std::uint64_t a = take();
    if (mask == 0) return a;
    const std::uint64_t b = take();
    if (mask == 0) {
        const std::uint64_t farther = a > b ? a : b;
        stack[height++] = farther;
        prefetch_child(view, farther);
        return a > b ? b : a;
    }
    const std::uint32_t first = height;
    stack[height++] = a;
    stack[height++] = b;
    do {
        stack[height++] = take();
    } while (mask != 0);
    for (std::uint32_t i = first; i < height; ++i)
        prefetch_child(view, stack[i]);
    if constexpr (!kAny) sort_entries(stack + first, stack + height);
    return stack[--height];
}

HM_ALWAYS_INLINE RaySpace enter_instance(const BvhInstanceRef& instance, const Ray& ray) {
    const auto& m = instance.world_to_object;
    float origin[3];
    float direction[3];
    for (int r = 0; r < 3; ++r) {
        direction[r] =
            m[0][r] * ray.direction.x + m[1][r] * ray.direction.y + m[2][r] * ray.direction.z;
        origin[r] =
            m[0][r] * ray.origin.x + m[1][r] * ray.origin.y + m[2][r] * ray.origin.z + m[3][r];
    }
    return make_ray_space(origin, direction, instance.bounds);
}

template <bool kAny, class Accept>
HM_ALWAYS_INLINE bool walk_bvh(const BvhView& view, const Ray& ray, BvhWalk& walk, Accept& accept) {
    walk = {ray.t_max, 0, 0, kBvhNoSlot, kBvhEmpty, kBvhEmpty, 0};
    const float origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const float direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    if (view.root == kBvhEmpty || !(ray.t_max > 0)) return false;
    if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0) return false;
    RaySpace space = make_ray_space(origin, direction, view.bounds);

    std::uint64_t stack[kBvhStackSize];
    std::uint32_t height = 0;
    std::uint64_t entry = view.root;
    for (;;) {
        std::uint32_t child = std::uint32_t(entry);
        while ((child & kBvhKindMask) == kBvhInner) {
            const BvhNode& node = view.nodes[child];
            Float8 distance;
            const std::uint32_t mask = enter_children(node, space.box, walk.best_t, distance);
            if (mask == 0) break;
            entry = push_children<kAny>(view, node, mask, distance, stack, height);
            child = std::uint32_t(entry);
        }
        const std::uint32_t index = child & ~kBvhKindMask;
        if ((child & kBvhKindMask) == kBvhPacket) {
            if (visit_packet<kAny>(view, index, space.triangle, walk, accept)) return true;
        } else if (child == kBvhLeaveInstance) {
            space = make_ray_space(origin, direction, view.bounds);
            walk.instance = kBvhEmpty;
            walk.instance_entry = 0;
        } else if ((child & kBvhKindMask) == kBvhInstance) {
            space = enter_instance(view.instances[index], ray);
            walk.instance = index;
            walk.instance_entry = __builtin_bit_cast(float, std::uint32_t(entry >> 32));
            stack[height++] = kBvhLeaveInstance;
            entry = view.instances[index].root;
            continue;
        }
        do {
            if (height == 0) return walk.best_slot != kBvhNoSlot;
            entry = stack[--height];
        } while (!(__builtin_bit_cast(float, std::uint32_t(entry >> 32)) <= walk.best_t));
    }
}

template <class Accept>
HM_ALWAYS_INLINE bool trace_closest(const BvhView& view, const Ray& ray, Hit& hit,
                                    Accept&& accept) {
    BvhWalk walk;
    if (!walk_bvh<false>(view, ray, walk, accept)) return false;
    const BvhTriangleId id = triangle_id(view, walk.best_instance, walk.best_slot);
    hit = {walk.best_t, walk.best_u, walk.best_v, id.instance, id.geometry, id.primitive};
    return true;
}

// Returns whether there is any hit with 0 < t < t_max.
template <class Accept>
HM_ALWAYS_INLINE bool trace_any(const BvhView& view, const Ray& ray, Accept&& accept) {
    BvhWalk walk;
    return walk_bvh<true>(view, ray, walk, accept);
}

}  // namespace hm
