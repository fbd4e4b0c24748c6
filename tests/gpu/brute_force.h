// The stages of shading/path with the simplest possible hooks: every ray is tested against every
// triangle.
// GLSL and C++ at once, included where the tables are visible (path_tables.glsl, path_tracer.h).
//
// Tables in addition to those of the stages: scene_vertices, scene_extras (parallel to the
// vertices), scene_triangles; scene_offsets: a geometry's first vertex and triangle; scene_images:
// first texel, width, height; scene_texels: every texel twice, as stored and decoded from sRGB;
// world_triangles: what rays meet, in ascending order of ids.
#include "shading/path/path.h"

HM_FN uvec2 image_size(uint image) {
    uvec3 i = scene_images[image];
    return uvec2(i.y, i.z);
}

HM_FN vec4 fetch_texel(uint image, uint x, uint y, uint encoding) {
    uvec3 i = scene_images[image];
    return scene_texels[2u * (i.x + y * i.y + x) + encoding];
}

HM_FN uvec3 corners(uint geometry, uint primitive) {
    uvec2 first = scene_offsets[geometry];
    return scene_triangles[first.y + primitive] + first.x;
}

HM_FN void load_triangle(uint geometry, uint primitive, HM_OUT(Triangle) triangle) {
    uvec3 c = corners(geometry, primitive);
    triangle.a = scene_vertices[c.x];
    triangle.b = scene_vertices[c.y];
    triangle.c = scene_vertices[c.z];
}

HM_FN void load_triangle_extras(uint geometry, uint primitive, HM_OUT(TriangleExtras) extras) {
    uvec3 c = corners(geometry, primitive);
    extras.a = scene_extras[c.x];
    extras.b = scene_extras[c.y];
    extras.c = scene_extras[c.z];
}

struct RayHit {
    HitIds ids;
    float distance;  // along the ray; < 0: no hit
    vec2 barycentrics;
};

// Moeller and Trumbore 1997. True if the hit is in (0, t_max).
HM_FN bool intersect(HM_IN(WorldTriangle) t, vec3 origin, vec3 direction, float t_max,
                     HM_OUT(RayHit) hit) {
    vec3 e1 = t.p1 - t.p0;
    vec3 e2 = t.p2 - t.p0;
    vec3 p = cross(direction, e2);
    float determinant = dot(e1, p);
    vec3 s = (origin - t.p0) / determinant;
    vec3 q = cross(s, e1);
    hit.ids = t.ids;
    hit.distance = dot(e2, q);
    hit.barycentrics = vec2(dot(s, p), dot(direction, q));
    // For a ray in the triangle's plane these are infinite or NaN, and the comparisons fail.
    return hit.barycentrics.x >= 0.0f && hit.barycentrics.y >= 0.0f &&
           hit.barycentrics.x + hit.barycentrics.y <= 1.0f && hit.distance > 0.0f &&
           hit.distance < t_max;
}

// The closest accepted hit before t_max, or with `any` the first found. Ids ascend, and only a
// smaller distance replaces a hit, so ties go to the lower ids.
HM_FN RayHit find_hit(vec3 origin, vec3 direction, float t_max, uint key, uint index, bool any) {
    RayHit best;
    best.distance = -1.0f;
    float limit = t_max;
    for (uint i = 0u; i < world_triangle_count; ++i) {
        RayHit hit;
        if (!intersect(world_triangles[i], origin, direction, limit, hit)) continue;
        if (!any_hit_accepts(key, index, hit.ids, hit.barycentrics)) continue;
        best = hit;
        if (any) return best;
        limit = hit.distance;
    }
    return best;
}

HM_FN void trace_path(HM_INOUT(PathPayload) payload, vec3 origin, vec3 direction) {
    RayHit hit = find_hit(origin, direction, kInfinity, payload.key, payload.index, false);
    if (hit.distance > 0.0f) {
        closest_hit(payload, hit.ids, origin, direction);
    } else {
        miss(payload, direction);
    }
}

HM_FN bool trace_visible(vec3 origin, vec3 direction, float t_max, uint key, uint index) {
    RayHit hit = find_hit(origin, direction, t_max, key, index, true);
    return hit.distance < 0.0f;
}
