// Stages without extended materials.

HM_FN vec3 surface_radiance(HM_IN(MaterialData) m, vec2 uv0, vec2 uv1, vec4 color, float) {
    return emitted_radiance(m, uv0, uv1, color);
}
