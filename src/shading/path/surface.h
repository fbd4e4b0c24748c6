// From ids and the ray to a shading point.
//
// Hooks: load_triangle and load_triangle_extras read a primitive of a geometry (index into
// `geometries`). Tables: instances, geometries, materials.

HM_HOOK(void load_triangle(uint geometry, uint primitive, HM_OUT(Triangle) triangle))
HM_HOOK(void load_triangle_extras(uint geometry, uint primitive, HM_OUT(TriangleExtras) extras))

struct Surface {
    vec3 position;
    vec3 ng;  // unit geometric normal, on the viewer's side
    vec3 ns;  // unit shading normal
    vec2 uv0;
    vec2 uv1;
    vec4 color;
    bool front;
    float hit_distance;
    vec3 weights;  // of the triangle's corners
    uint material;
    uint geometry;
    float error;  // of the position along ng: rays start that far off the surface
};

HM_FN vec3 transform_point(HM_IN(mat4x3) m, vec3 p) {
    return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
}

HM_FN vec3 transform_vector(HM_IN(mat4x3) m, vec3 v) {
    return m[0] * v.x + m[1] * v.y + m[2] * v.z;
}

// Normals by the transposed inverse.
HM_FN vec3 transform_normal(HM_IN(mat4x3) world_to_object, vec3 n) {
    return vec3(dot(world_to_object[0], n), dot(world_to_object[1], n), dot(world_to_object[2], n));
}

// uv1 and vertex colour; 0 and 1 for geometry without extras.
HM_FN void load_extras(uint geometry, uint primitive, vec3 weights, HM_OUT(vec2) uv1,
                       HM_OUT(vec4) color) {
    uv1 = vec2(0.0f);
    color = vec4(1.0f);
    if ((geometries[geometry].flags & kGeometryHasExtras) == 0u) return;
    TriangleExtras e;
    load_triangle_extras(geometry, primitive, e);
    uv1 = e.a.uv1 * weights.x + e.b.uv1 * weights.y + e.c.uv1 * weights.z;
    color = e.a.color * weights.x + e.b.color * weights.y + e.c.color * weights.z;
}

// A normal map's normal in world space: 2 texel - 1, whose x and y `scale` scales, normalized (glTF
// 2.0, 3.9.3), about the surface's ns.
HM_FN vec3 map_normal(HM_IN(InstanceData) instance, HM_IN(Surface) s, vec4 tangent_object,
                      vec4 texel, float scale) {
    vec3 t = transform_vector(instance.object_to_world,
                              vec3(tangent_object.x, tangent_object.y, tangent_object.z));
    t = t - s.ns * dot(s.ns, t);
    float length_squared = dot(t, t);
    if (!(length_squared > 1e-30f)) return s.ns;
    t = t * inversesqrt(length_squared);
    float mirrored = (instance.flags & kInstanceFlipped) != 0u ? -1.0f : 1.0f;
    vec3 b = cross(s.ns, t) * (tangent_object.w * mirrored);
    float x = 2.0f * texel.x - 1.0f;
    float y = 2.0f * texel.y - 1.0f;
    float z = 2.0f * texel.z - 1.0f;
    vec3 n = t * (x * scale) + b * (y * scale) + s.ns * max(z, 1e-3f);
    return normalize(n);
}

HM_FN vec4 interpolated_tangent(HM_IN(Triangle) t, vec3 weights) {
    vec4 tangent = t.a.tangent * weights.x + t.b.tangent * weights.y + t.c.tangent * weights.z;
    tangent.w = tangent.w < 0.0f ? -1.0f : 1.0f;
    return tangent;
}

// The vertices' normal in world space, or ng where they have none.
HM_FN vec3 interpolated_normal(HM_IN(InstanceData) instance, uint geometry_flags, HM_IN(Triangle) t,
                               vec3 weights, vec3 ng) {
    vec3 ns = ng;
    if ((geometry_flags & kGeometryHasNormals) != 0u) {
        vec3 n = t.a.normal * weights.x + t.b.normal * weights.y + t.c.normal * weights.z;
        n = transform_normal(instance.world_to_object, n);
        float length_squared = dot(n, n);
        if (length_squared > 1e-30f) ns = n * inversesqrt(length_squared);
    }
    return ns;
}

// A shading normal that suits the geometry: on the wrong side of the surface it is a modelling
// error and reflected back, then it is bent until it mirrors wo above the surface.
HM_FN vec3 repaired_normal(vec3 ns, vec3 ng, vec3 wo) {
    vec3 n = ns;
    float aligned = dot(n, ng);
    if (aligned < 0.0f) n = normalize(n - 2.0f * aligned * ng);
    return bend_shading_normal(n, ng, wo);
}

// Intersects a ray with the plane of a triangle: barycentric weights and distance (Moeller and
// Trumbore 1997, with the normal edge1 x edge2). Recomputed here, because the results of traversal
// differ between devices by more than rounding, and mirrors amplify the difference.
HM_FN vec3 meet_triangle(vec3 to_origin, vec3 edge1, vec3 edge2, vec3 normal, vec3 direction,
                         HM_OUT(float) hit_distance) {
    float inverse = divide(-1.0f, dot(direction, normal));
    vec3 m = cross(to_origin, direction);
    float u = clamp(dot(edge2, m) * inverse, 0.0f, 1.0f);
    float v = clamp(-dot(edge1, m) * inverse, 0.0f, 1.0f - u);
    hit_distance = max(dot(to_origin, normal) * inverse, 0.0f);
    // Rays within the plane, which hit by rounding only.
    if (!(u >= 0.0f && v >= 0.0f)) return vec3(1.0f, 0.0f, 0.0f);
    return vec3(1.0f - u - v, u, v);
}

// The hit point without its material. `origin` and `direction` are the ray's.
HM_FN void load_surface(HM_IN(HitIds) ids, vec3 origin, vec3 direction, HM_OUT(Surface) s) {
    HM_ROW(InstanceData) instance = instances[ids.instance];
    s.geometry = instance.first_geometry + ids.geometry;
    HM_ROW(GeometryData) geometry = geometries[s.geometry];
    s.material = geometry.material;
    Triangle t;
    load_triangle(s.geometry, ids.primitive, t);
    vec3 edge1 = transform_vector(instance.object_to_world, t.b.position - t.a.position);
    vec3 edge2 = transform_vector(instance.object_to_world, t.c.position - t.a.position);
    vec3 normal = cross(edge1, edge2);
    vec3 to_origin = origin - transform_point(instance.object_to_world, t.a.position);
    vec3 weights = meet_triangle(to_origin, edge1, edge2, normal, direction, s.hit_distance);
    s.weights = weights;
    s.position = transform_point(
        instance.object_to_world,
        t.a.position * weights.x + t.b.position * weights.y + t.c.position * weights.z);
    s.ng = normalize(normal);
    if ((instance.flags & kInstanceFlipped) != 0u) s.ng = -s.ng;
    s.front = dot(s.ng, direction) < 0.0f;
    s.error = hit_error(transform_magnitude(instance, abs(s.position)),
                        triangle_extent(edge1, edge2), s.ng);
    s.uv0 = t.a.uv0 * weights.x + t.b.uv0 * weights.y + t.c.uv0 * weights.z;
    load_extras(s.geometry, ids.primitive, weights, s.uv1, s.color);

    s.ns = interpolated_normal(instance, geometry.flags, t, weights, s.ng);
    if ((geometry.flags & kGeometryNormalMapped) != 0u) {
        vec4 tangent = interpolated_tangent(t, weights);
        HM_ROW(MaterialData) m = materials[s.material];
        s.ns = map_normal(instance, s, tangent, read_normal(m, s.uv0, s.uv1), m.normal_scale);
    }
    if (!s.front) {
        s.ng = -s.ng;
        s.ns = -s.ns;
    }
    s.ns = repaired_normal(s.ns, s.ng, -direction);
}
