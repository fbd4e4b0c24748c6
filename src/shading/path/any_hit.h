// The any-hit stage: whether a triangle of a mask or blend material stops this ray.

// The number in [0, 1) that stochastic alpha compares with, for one triangle and one ray of a
// sample: a function of the ray's key, the sample's index and the triangle's ids, so the answer
// depends on neither visiting order nor device. Over the indices it is a van der Corput sequence,
// shuffled (Burley 2020) by a hash of key and ids: each aligned block of 2^k samples has one number
// in every interval of length 2^-k, and triangles are independent of each other. Scrambling the
// digits instead of shuffling would not do: the leading digit of all triangles would be the index's
// lowest, so layers would be correlated, however many samples there are.
HM_FN float alpha_number(uint key, uint index, HM_IN(HitIds) ids) {
    uint h =
        hash_combine(hash_combine(hash_combine(key, ids.instance), ids.geometry), ids.primitive);
    if (params.sampler_kind == kSamplerIndependent) return unit_float(h);
    return unit_float(owen_scramble_reversed(reverse_bits(index), h));
}

// Blend is stochastic: a hit counts with probability alpha.
HM_FN bool any_hit_accepts(uint key, uint index, HM_IN(HitIds) ids, vec2 barycentrics) {
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
    return alpha_number(key, index, ids) < alpha;
}
