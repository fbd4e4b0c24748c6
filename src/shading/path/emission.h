// Emissive triangles: what they radiate and how light sampling finds them.
//
// Tables: emitters, emitter_alias.

HM_FN vec4 base_color(HM_IN(MaterialData) m, vec2 uv0, vec2 uv1, vec4 color) {
    return m.base_color_factor * sample_texture(m.base_color_texture, kEncodingSrgb, uv0, uv1) *
           color;
}

// The probability that any-hit keeps a hit of this alpha.
HM_FN float alpha_coverage(HM_IN(MaterialData) m, float alpha) {
    if (m.alpha_mode == kAlphaMask) return alpha >= m.alpha_cutoff ? 1.0f : 0.0f;
    if (m.alpha_mode == kAlphaBlend) return saturate(alpha);
    return 1.0f;
}

HM_FN vec3 emitted_radiance(HM_IN(MaterialData) m, vec2 uv0, vec2 uv1, vec4 color) {
    if ((m.flags & kMaterialUnlit) != 0u) {
        vec4 c = base_color(m, uv0, uv1, color);
        return vec3(c.x, c.y, c.z);
    }
    if (max_component(m.emissive_factor) <= 0.0f) return vec3(0.0f);
    vec4 texel = sample_texture(m.emissive_texture, kEncodingSrgb, uv0, uv1);
    return m.emissive_factor * vec3(texel.x, texel.y, texel.z);
}

// Solid-angle density with which sample_emitter finds the point of an emissive triangle from where
// a ray came. 0 if the triangle is never sampled.
HM_FN float pdf_emitter(HM_IN(HitIds) ids, uint geometry, float hit_distance, float cos_light) {
    uint offset = geometries[geometry].emitter_offset;
    if (offset == kNone || params.emitter_range.pdf <= 0.0f) return 0.0f;
    uint index = instances[ids.instance].first_emitter + offset + ids.primitive;
    HM_ROW(EmitterTriangle) e = emitters[index];
    float double_area = length(cross(e.p1 - e.p0, e.p2 - e.p0));
    return params.emitter_range.pdf * emitter_alias[index].pdf_self * 2.0f * hit_distance *
           hit_distance / max(double_area * cos_light, 1e-30f);
}

HM_FN uint material_source(uint material) {
    return 1u + params.light_count + material;
}

struct LightSample {
    vec3 wi;         // unit, towards the light
    float distance;  // to where visibility is to be tested
    vec3 radiance;   // times alpha coverage for emitters; irradiance for punctual lights
    float pdf;       // solid angle; for punctual lights the discrete probability
    bool punctual;   // cannot be met by BSDF sampling
    uint source;     // see kSourceEnvironment
};

HM_FN void sample_emitter(uint choice, uint coin, float u, float v, vec3 p,
                          HM_OUT(LightSample) light) {
    light.radiance = vec3(0.0f);
    light.pdf = 0.0f;
    light.punctual = false;
    light.source = kSourceEnvironment;
    light.wi = vec3(0.0f, 0.0f, 1.0f);
    light.distance = 0.0f;
    uint slot = mul_high(choice, params.emitter_count);
    HM_ROW(AliasEntry) entry = emitter_alias[slot];
    bool own = coin < entry.threshold;
    uint index = own ? slot : entry.alias;
    float p_select = own ? entry.pdf_self : entry.pdf_alias;
    HM_ROW(EmitterTriangle) e = emitters[index];
    HM_ROW(InstanceData) instance = instances[e.instance];
    uint geometry = instance.first_geometry + e.geometry;
    HM_ROW(MaterialData) m = materials[geometries[geometry].material];
    light.source = material_source(geometries[geometry].material);

    vec2 barycentrics = sample_triangle(u, v);
    vec3 weights = vec3(1.0f - barycentrics.x - barycentrics.y, barycentrics.x, barycentrics.y);
    vec3 q = e.p0 * weights.x + e.p1 * weights.y + e.p2 * weights.z;
    vec3 scaled_normal = cross(e.p1 - e.p0, e.p2 - e.p0);
    float double_area = sqrt(dot(scaled_normal, scaled_normal));
    vec3 n = scaled_normal * divide(1.0f, max(double_area, 1e-30f));
    if ((instance.flags & kInstanceFlipped) != 0u) n = -n;
    bool front = dot(n, p - q) > 0.0f;
    if (!front && (m.flags & kMaterialDoubleSided) == 0u) return;
    // The shadow ray ends in front of the emitter, so it never meets the emitter itself.
    vec3 target = offset_ray_origin(q, front ? n : -n);
    vec3 to_light = target - p;
    float distance_squared = dot(to_light, to_light);
    if (!(distance_squared > 0.0f)) return;
    light.distance = sqrt(distance_squared);
    light.wi = to_light * divide(1.0f, light.distance);
    float cos_light = abs(dot(n, light.wi));
    if (!(cos_light > 0.0f)) return;
    light.pdf = p_select * 2.0f * distance_squared / (double_area * cos_light);

    vec2 uv0 = vec2(0.0f);
    vec2 uv1 = vec2(0.0f);
    vec4 color = vec4(1.0f);
    bool unlit = (m.flags & kMaterialUnlit) != 0u;
    bool plain = texture_uses[m.emissive_texture].image == kImageWhite &&
                 m.alpha_mode == kAlphaOpaque && !unlit;
    if (!plain) {
        Triangle t;
        load_triangle(geometry, e.primitive, t);
        uv0 = t.a.uv0 * weights.x + t.b.uv0 * weights.y + t.c.uv0 * weights.z;
        load_extras(geometry, e.primitive, weights, uv1, color);
    }
    light.radiance = emitted_radiance(m, uv0, uv1, color);
    if (m.alpha_mode != kAlphaOpaque)
        light.radiance = light.radiance * alpha_coverage(m, base_color(m, uv0, uv1, color).w);
}
