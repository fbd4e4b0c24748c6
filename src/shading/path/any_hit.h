// The any-hit stage: whether a triangle of a mask or blend material stops this ray.

// Blend is stochastic: a hash of the ray's key and the triangle's ids against alpha, so the answer
// depends on neither visiting order nor device.
HM_FN bool any_hit_accepts(uint key, HM_IN(HitIds) ids, vec2 barycentrics) {
    uint geometry = instances[ids.instance].first_geometry + ids.geometry;
    HM_ROW(MaterialData) m = materials[geometries[geometry].material];
    if (m.alpha_mode == kAlphaOpaque) return true;
    Triangle t;
    load_triangle(geometry, ids.primitive, t);
    vec3 weights = vec3(1.0f - barycentrics.x - barycentrics.y, barycentrics.x, barycentrics.y);
    vec2 uv0 = t.a.uv0 * weights.x + t.b.uv0 * weights.y + t.c.uv0 * weights.z;
    vec2 uv1;
    vec4 color;
    load_extras(geometry, ids.primitive, weights, uv1, color);
    float alpha = base_color(m, uv0, uv1, color).w;
    if (m.alpha_mode == kAlphaMask) return alpha >= m.alpha_cutoff;
    uint h =
        hash_combine(hash_combine(hash_combine(key, ids.instance), ids.geometry), ids.primitive);
    return unit_float(h) < alpha;
}
