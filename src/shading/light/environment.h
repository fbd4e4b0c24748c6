// The environment: an equirectangular map, bilinear, sampled by an alias table over the mean of the
// filtered lookup in each texel's cell. u = 0.5 + atan2(d.z, d.x) / 2 pi, v = acos(d.y) / pi, row 0
// at the top.
//
// Tables: environment_texels[w * h] (vec4, intensity not applied), environment_alias[w * h].

HM_FN vec2 environment_uv(vec3 d) {
    float u = 0.5f + atan2_over_2pi(d.z, d.x) + environment.u_offset;
    float v = 2.0f * atan2_over_2pi(sqrt(d.x * d.x + d.z * d.z), d.y);
    return vec2(u - floor(u), clamp(v, 0.0f, 1.0f));
}

HM_FN vec3 environment_texel(uint x, uint y) {
    vec4 texel = environment_texels[y * environment.width + x];
    return vec3(texel.x, texel.y, texel.z);
}

HM_FN vec3 environment_radiance(vec2 uv) {
    HM_MAY_CONTRACT
    int w = int(environment.width);
    int h = int(environment.height);
    float x = uv.x * float(w) - 0.5f;
    float y = uv.y * float(h) - 0.5f;
    float left = floor(x);
    float top = floor(y);
    float fx = x - left;
    float fy = y - top;
    uint i0 = wrap_texel(int(left), w, kWrapRepeat);
    uint i1 = wrap_texel(int(left) + 1, w, kWrapRepeat);
    uint j0 = wrap_texel(int(top), h, kWrapClamp);
    uint j1 = wrap_texel(int(top) + 1, h, kWrapClamp);
    vec3 upper = environment_texel(i0, j0) * (1.0f - fx) + environment_texel(i1, j0) * fx;
    vec3 lower = environment_texel(i0, j1) * (1.0f - fx) + environment_texel(i1, j1) * fx;
    return (upper * (1.0f - fy) + lower * fy) * environment.intensity;
}

// From the probability of a texel to solid angle: W H / (2 pi^2 sin theta).
HM_FN float environment_pdf_scale(float sin_theta) {
    return float(environment.width) * float(environment.height) /
           (2.0f * kPi * kPi * max(sin_theta, 1e-7f));
}

HM_FN float pdf_environment(vec3 d, vec2 uv) {
    uint x = min(uint(uv.x * float(environment.width)), environment.width - 1u);
    uint y = min(uint(uv.y * float(environment.height)), environment.height - 1u);
    float sin_theta = sqrt(d.x * d.x + d.z * d.z);
    return environment_alias[y * environment.width + x].pdf_self * environment_pdf_scale(sin_theta);
}

// A direction, its radiance and density. choice and coin are 32-bit numbers, u and v in [0, 1).
HM_FN vec3 sample_environment(uint choice, uint coin, float u, float v, HM_OUT(vec3) radiance,
                              HM_OUT(float) pdf) {
    uint slot = alias_slot(choice, environment.width * environment.height);
    AliasDraw drawn;
    draw_alias(slot, environment_alias[slot], coin, drawn);
    uint y = drawn.index / environment.width;
    uint x = drawn.index - y * environment.width;
    vec2 uv = vec2(divide(float(x) + u, float(environment.width)),
                   divide(float(y) + v, float(environment.height)));
    vec2 theta = cos_sin_2pi(0.5f * uv.y);
    float turn = uv.x - 0.5f - environment.u_offset;
    vec2 phi = cos_sin_2pi(turn - floor(turn));
    radiance = environment_radiance(uv);
    pdf = drawn.pdf * environment_pdf_scale(theta.y);
    return vec3(theta.y * phi.x, theta.x, theta.y * phi.y);
}
