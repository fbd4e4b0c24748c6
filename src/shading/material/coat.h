// The clear coat of KHR_materials_clearcoat: a GGX layer of index 1.5 above everything else, with a
// normal of its own. What it does not reflect reaches the layers below.

HM_CONST float kCoatF0 = 0.04f;

struct CoatLobe {
    float weight;  // 0: no coat
    vec2 alpha;
    Frame frame;  // around the coat's normal, in the local space of the material
    vec3 wo;      // in that frame
    float pdf_scale;
    float passage;  // share of light that reaches the layers below
};

// The albedo of a full coat; also what an emissive surface below it loses.
HM_FN float coat_albedo(float cos_theta, float roughness) {
    vec2 e = lookup_albedo(cos_theta, max(roughness, kMinRoughness));
    return kCoatF0 * e.x + e.y;
}

HM_FN void make_coat(float weight, float roughness, vec3 normal, vec3 wo, HM_OUT(CoatLobe) lobe) {
    HM_MAY_CONTRACT
    float r = clamp(roughness, kMinRoughness, 1.0f);
    make_frame(normal, lobe.frame);
    lobe.wo = to_local(lobe.frame, wo);
    lobe.weight = lobe.wo.z > 0.0f ? weight : 0.0f;
    lobe.alpha = vec2(r * r);
    lobe.pdf_scale = anisotropic_reflection_pdf_scale(lobe.wo, lobe.alpha);
    lobe.passage = 1.0f - lobe.weight * coat_albedo(lobe.wo.z, r);
}

// f cos_i, and the density of sampling wi.
HM_FN float eval_coat(HM_IN(CoatLobe) lobe, vec3 wi_local, HM_OUT(float) pdf) {
    HM_MAY_CONTRACT
    pdf = 0.0f;
    vec3 wi = to_local(lobe.frame, wi_local);
    if (!(lobe.weight > 0.0f) || !(wi.z > 0.0f)) return 0.0f;
    vec3 h = fast_normalize(lobe.wo + wi);
    float d = eval_anisotropic_d(h, lobe.alpha);
    pdf = d * lobe.pdf_scale;
    float fresnel = kCoatF0 + (1.0f - kCoatF0) * pow5(1.0f - saturate(dot(lobe.wo, h)));
    return lobe.weight * fresnel * d * wi.z *
           eval_smith_v(lobe.wo.z, stretched_length(lobe.wo, lobe.alpha), wi.z,
                        stretched_length(wi, lobe.alpha));
}

HM_FN vec3 sample_coat(HM_IN(CoatLobe) lobe, float u, float v) {
    return to_world(lobe.frame, sample_anisotropic_reflection(lobe.wo, lobe.alpha, u, v));
}
