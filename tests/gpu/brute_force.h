// The stages of shading/path with the simplest hooks there can be: every ray meets every triangle.
// GLSL and C++ at once, included where the tables are visible (path_tables.glsl, path_tracer.h).
//
// Tables beside those of the stages: scene_vertices, scene_extras (beside the vertices),
// scene_triangles; scene_offsets: a geometry's first vertex and triangle; scene_images: first
// texel, width, height; scene_texels: rgba8, red in the lowest byte.
#include "shading/path/path.h"

HM_FN uvec2 image_size(uint image) {
    uvec3 i = scene_images[image];
    return uvec2(i.y, i.z);
}

HM_FN float decode_channel(uint texel, uint shift, uint srgb) {
    float encoded = float((texel >> shift) & 255u) * (1.0f / 255.0f);
    return srgb != 0u && shift < 24u ? srgb_to_linear(encoded) : encoded;
}

HM_FN vec4 fetch_texel(uint image, uint x, uint y, uint srgb) {
    uint texel = scene_texels[scene_images[image].x + y * scene_images[image].y + x];
    return vec4(decode_channel(texel, 0u, srgb), decode_channel(texel, 8u, srgb),
                decode_channel(texel, 16u, srgb), decode_channel(texel, 24u, srgb));
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

// Moeller and Trumbore 1997, in world space. True if the hit is in (0, t_max).
HM_FN bool intersect(uint instance, uint geometry, uint primitive, vec3 origin, vec3 direction,
                     float t_max, HM_OUT(RayHit) hit) {
    Triangle t;
    load_triangle(geometry, primitive, t);
    vec3 a = transform_point(instances[instance].object_to_world, t.a.position);
    vec3 e1 = transform_point(instances[instance].object_to_world, t.b.position) - a;
    vec3 e2 = transform_point(instances[instance].object_to_world, t.c.position) - a;
    vec3 p = cross(direction, e2);
    float determinant = dot(e1, p);
    hit.distance = -1.0f;
    hit.barycentrics = vec2(0.0f);
    hit.ids.instance = instance;
    hit.ids.geometry = geometry - instances[instance].first_geometry;
    hit.ids.primitive = primitive;
    if (determinant == 0.0f) return false;
    vec3 s = (origin - a) / determinant;
    float u = dot(s, p);
    vec3 q = cross(s, e1);
    float v = dot(direction, q);
    float distance = dot(e2, q);
    if (u < 0.0f || v < 0.0f || u + v > 1.0f || distance <= 0.0f || distance >= t_max) return false;
    hit.distance = distance;
    hit.barycentrics = vec2(u, v);
    return true;
}

// The closest accepted hit before t_max, or with `any` the first found. Ids ascend, and only a
// smaller distance replaces a hit, so ties go to the lower ids.
HM_FN RayHit find_hit(vec3 origin, vec3 direction, float t_max, uint key, bool any) {
    RayHit best;
    best.distance = -1.0f;
    float limit = t_max;
    for (uint instance = 0u; instance < instance_count; ++instance) {
        uint first = instances[instance].first_geometry;
        for (uint geometry = first; geometry < first + mesh_geometry_counts[instance]; ++geometry) {
            for (uint i = 0u; i < geometries[geometry].triangle_count; ++i) {
                RayHit hit;
                if (!intersect(instance, geometry, i, origin, direction, limit, hit)) continue;
                if (!any_hit_accepts(key, hit.ids, hit.barycentrics)) continue;
                best = hit;
                if (any) return best;
                limit = hit.distance;
            }
        }
    }
    return best;
}

HM_FN void trace_path(HM_INOUT(PathPayload) payload, vec3 origin, vec3 direction) {
    RayHit hit = find_hit(origin, direction, kInfinity, payload.key, false);
    if (hit.distance > 0.0f) {
        closest_hit(payload, hit.ids, hit.distance, hit.barycentrics, direction);
    } else {
        miss(payload, direction);
    }
}

HM_FN bool trace_visible(vec3 origin, vec3 direction, float t_max, uint key) {
    RayHit hit = find_hit(origin, direction, t_max, key, true);
    return hit.distance < 0.0f;
}
