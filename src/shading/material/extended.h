// What a material with extensions says at one point of a surface, textures applied, and what its
// coat leaves of emission.
//
// Tables: extended_materials, texture_uses.

HM_FN bool is_extended(HM_IN(MaterialData) m) {
    return (m.flags >> kMaterialRowShift) != 0u;
}

HM_FN uint extended_row(HM_IN(MaterialData) m) {
    return (m.flags >> kMaterialRowShift) - 1u;
}

// Direction and strength of the anisotropy: the texture's direction, rotated.
HM_FN void load_anisotropy(HM_IN(ExtendedMaterialData) m, vec4 texel, HM_INOUT(ExtendedPoint) p) {
    p.anisotropy = 0.0f;
    p.anisotropy_direction = vec2(1.0f, 0.0f);
    if (!(m.anisotropy > 0.0f)) return;
    vec2 direction = vec2(1.0f, 0.0f);
    if (m.anisotropy_texture != 0u) direction = vec2(2.0f * texel.x - 1.0f, 2.0f * texel.y - 1.0f);
    float turns = m.anisotropy_rotation * (0.5f * kInvPi);
    vec2 r = cos_sin_2pi(turns - floor(turns));
    vec2 turned =
        vec2(r.x * direction.x - r.y * direction.y, r.y * direction.x + r.x * direction.y);
    float size = turned.x * turned.x + turned.y * turned.y;
    if (!(size > 1e-8f)) return;
    p.anisotropy = saturate(m.anisotropy * texel.z);
    p.anisotropy_direction = turned * inversesqrt(size);
}

// `base` is load_material's point, whose roughness specular-glossiness replaces.
HM_FN void load_extended(HM_IN(MaterialData) m, HM_IN(ExtendedMaterialData) x,
                         HM_IN(ExtendedTexels) t, HM_INOUT(MaterialPoint) base,
                         HM_OUT(ExtendedPoint) p) {
    p.specular_color =
        x.specular_color * vec3(t.specular_color.x, t.specular_color.y, t.specular_color.z);
    p.specular = x.specular * base.specular_weight * t.specular.w;
    p.ior = x.ior;
    p.glossy = (m.flags & kMaterialGlossy) != 0u;
    if (p.glossy) base.roughness = 1.0f - (1.0f - m.roughness_factor) * t.specular_color.w;
    p.clearcoat = x.clearcoat * t.clearcoat.x;
    p.clearcoat_roughness = x.clearcoat_roughness * t.clearcoat_roughness.y;
    p.sheen_color = x.sheen_color * vec3(t.sheen_color.x, t.sheen_color.y, t.sheen_color.z);
    p.sheen_roughness = x.sheen_roughness * t.sheen_roughness.w;
    load_anisotropy(x, t.anisotropy, p);
    p.iridescence = x.iridescence * t.iridescence.x;
    p.iridescence_ior = x.iridescence_ior;
    float thickness = t.iridescence_thickness.y;
    p.iridescence_thickness = x.iridescence_thickness_minimum * (1.0f - thickness) +
                              x.iridescence_thickness_maximum * thickness;
    p.transmission = x.transmission * t.transmission.x;
    p.diffuse_transmission = x.diffuse_transmission * t.diffuse_transmission.w;
    p.diffuse_transmission_color =
        x.diffuse_transmission_color * vec3(t.diffuse_transmission_color.x,
                                            t.diffuse_transmission_color.y,
                                            t.diffuse_transmission_color.z);
}

// The share of an extended surface's emission that passes its coat.
HM_FN float coat_passage(HM_IN(MaterialData) m, vec2 uv0, vec2 uv1, float cos_theta) {
    HM_ROW(ExtendedMaterialData) x = extended_materials[extended_row(m)];
    if (!(x.clearcoat > 0.0f)) return 1.0f;
    float weight = x.clearcoat * sample_texture(x.clearcoat_texture, kEncodingLinear, uv0, uv1).x;
    float roughness = x.clearcoat_roughness *
                      sample_texture(x.clearcoat_roughness_texture, kEncodingLinear, uv0, uv1).y;
    return 1.0f - weight * coat_albedo(cos_theta, roughness);
}

// What a surface emits at a cosine to its geometric normal: light sampling and hits ask alike.
HM_FN vec3 surface_radiance(HM_IN(MaterialData) m, vec2 uv0, vec2 uv1, vec4 color,
                            float cos_theta) {
    vec3 emitted = emitted_radiance(m, uv0, uv1, color);
    if (is_extended(m)) emitted = emitted * coat_passage(m, uv0, uv1, cos_theta);
    return emitted;
}
