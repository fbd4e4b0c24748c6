// Emissive triangles: points on them for light sampling, and the density of those points.
//
// Tables: emitters, emitter_alias.

// The number of an emissive material as a source of light (see kSourceEnvironment).
HM_FN uint material_source(uint material) {
    return 1u + params.light_count + material;
}

// The index of a triangle in `emitters`, kNone if it is not there.
HM_FN uint emitter_index(HM_IN(HitIds) ids, uint geometry) {
    uint offset = geometries[geometry].emitter_offset;
    if (offset == kNone) return kNone;
    return instances[ids.instance].first_emitter + offset + ids.primitive;
}

// Solid-angle density with which sample_emitter finds a point of the triangle, seen at this
// distance, times the probability of sampling emitters at all.
HM_FN float pdf_emitter(float probability, uint index, float hit_distance, float cos_light) {
    HM_ROW(EmitterTriangle) e = emitters[index];
    float double_area = length(cross(e.p1 - e.p0, e.p2 - e.p0));
    return probability * emitter_alias[index].pdf_self * 2.0f * hit_distance * hit_distance /
           max(double_area * cos_light, 1e-30f);
}

// The radiance of an emitter's point at this cosine, times its alpha coverage.
HM_FN vec3 emitter_radiance(HM_IN(EmitterTriangle) e, uint geometry, vec3 weights,
                            HM_IN(MaterialData) m, float cos_light) {
    vec2 uv0 = vec2(0.0f);
    vec2 uv1 = vec2(0.0f);
    vec4 color = vec4(1.0f);
    bool unlit = (m.flags & kMaterialUnlit) != 0u;
    bool plain = texture_uses[m.emissive_texture].image == kImageWhite &&
                 m.alpha_mode == kAlphaOpaque && !unlit;
#ifdef HM_EXTENDED
    plain = plain && !is_extended(m);
#endif
    if (!plain) {
        Triangle t;
        load_triangle(geometry, e.primitive, t);
        uv0 = t.a.uv0 * weights.x + t.b.uv0 * weights.y + t.c.uv0 * weights.z;
        load_extras(geometry, e.primitive, weights, uv1, color);
    }
    vec3 radiance = surface_radiance(m, uv0, uv1, color, cos_light);
    if (m.alpha_mode == kAlphaOpaque) return radiance;
    return radiance * alpha_coverage(m, base_color(m, uv0, uv1, color).w);
}

// A point on an emissive triangle, seen from p. `light` comes in as an empty sample and stays one,
// but for its source, where the point cannot light p.
HM_FN void sample_emitter(uint choice, uint coin, float u, float v, vec3 p,
                          HM_INOUT(LightSample) light) {
    uint slot = alias_slot(choice, params.emitter_count);
    AliasDraw drawn;
    draw_alias(slot, emitter_alias[slot], coin, drawn);
    HM_ROW(EmitterTriangle) e = emitters[drawn.index];
    HM_ROW(InstanceData) instance = instances[e.instance];
    uint geometry = instance.first_geometry + e.geometry;
    HM_ROW(MaterialData) m = materials[geometries[geometry].material];
    light.source = material_source(geometries[geometry].material);

    vec2 barycentrics = sample_triangle(u, v);
    vec3 weights = vec3(1.0f - barycentrics.x - barycentrics.y, barycentrics.x, barycentrics.y);
    vec3 q = e.p0 * weights.x + e.p1 * weights.y + e.p2 * weights.z;
    vec3 scaled_normal = cross(e.p1 - e.p0, e.p2 - e.p0);
    float double_area = sqrt(dot(scaled_normal, scaled_normal));
    if (!(double_area > 0.0f)) return;
    vec3 n = scaled_normal * divide(1.0f, double_area);
    if ((instance.flags & kInstanceFlipped) != 0u) n = -n;
    bool front = dot(n, p - q) > 0.0f;
    if (!front && (m.flags & kMaterialDoubleSided) == 0u) return;
    // The shadow ray ends in front of the emitter, so it never meets the emitter itself: by the
    // error of hits along the normal, and below by the error that grows with the ray's length.
    vec3 to_light = q + n * (front ? e.error : -e.error) - p;
    float distance_squared = dot(to_light, to_light);
    if (!(distance_squared > 0.0f)) return;
    light.distance = sqrt(distance_squared);
    light.wi = to_light * divide(1.0f, light.distance);
    float cos_light = abs(dot(n, light.wi));
    if (!(cos_light > 0.0f)) return;
    light.pdf = drawn.pdf * 2.0f * distance_squared / (double_area * cos_light);
    light.distance = light.distance - ray_end_error(0.0f, n, light.wi, light.distance);
    light.radiance = emitter_radiance(e, geometry, weights, m, cos_light);
}
