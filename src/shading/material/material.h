// What a material's parameters and textures say: colour, alpha, emission, and the MaterialPoint
// that the BSDF is made from.
//
// Tables: texture_uses.

HM_FN vec4 base_color(HM_IN(MaterialData) m, vec2 uv0, vec2 uv1, vec4 color) {
    return m.base_color_factor * read_base_color(m, uv0, uv1) * color;
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
    vec4 texel = read_emissive(m, uv0, uv1);
    return m.emissive_factor * vec3(texel.x, texel.y, texel.z);
}

HM_FN void load_material(HM_IN(MaterialData) m, HM_IN(Surface) s, HM_OUT(MaterialPoint) p) {
    vec4 base = base_color(m, s.uv0, s.uv1, s.color);
    vec4 texel = read_metallic_roughness(m, s.uv0, s.uv1);
    p.base_color = vec3(base.x, base.y, base.z);
    p.metallic = saturate(m.metallic_factor * texel.z);
    p.roughness = m.roughness_factor * texel.y;
    p.specular_weight = m.specular_weight;
}
