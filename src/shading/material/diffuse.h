// The diffuse lobe: a Lambertian base (or Burley's) below the dielectric's specular layer, which
// lets through what it does not reflect. Appendix B takes the layer's Fresnel at the half vector;
// with energy compensation the base is weighted by what the layer lets in and out, reciprocally:
// (1 - L(wo)) (1 - L(wi)) / (1 - L_avg), L the layer's albedo. Directions are local.

struct DiffuseLobe {
    vec3 color;      // base colour times 1 - metallic
    float layer_f0;  // of the dielectric
    float layer_f90;
    float layer_multiple;  // F_ms of the layer's multiple scattering; 0 without compensation
    float scale;           // (1 - L(wo)) / (1 - L_avg); 1 without compensation
    float probability;     // of sampling this lobe
};

// Without compensation; the mixture sets the probability.
HM_FN void make_diffuse(HM_IN(MaterialPoint) m, HM_OUT(DiffuseLobe) lobe) {
    lobe.color = m.base_color * (1.0f - m.metallic);
    lobe.layer_f0 = kDielectricF0 * m.specular_weight;
    lobe.layer_f90 = m.specular_weight;
    lobe.layer_multiple = 0.0f;
    lobe.scale = 1.0f;
    lobe.probability = 0.0f;
}

// L for a split albedo of the mirror.
HM_FN float albedo_layer(HM_IN(DiffuseLobe) lobe, vec2 e) {
    HM_MAY_CONTRACT
    return lobe.layer_f0 * e.x + lobe.layer_f90 * e.y + (1.0f - (e.x + e.y)) * lobe.layer_multiple;
}

// `e` and `average` are the mirror's split albedo, towards wo and on average.
HM_FN void compensate_diffuse(vec2 e, vec2 average, HM_INOUT(DiffuseLobe) lobe) {
    HM_MAY_CONTRACT
    lobe.layer_multiple = multiple_fresnel(lobe.layer_f0, lobe.layer_f90, average.x + average.y);
    lobe.scale = (1.0f - albedo_layer(lobe, e)) / max(1.0f - albedo_layer(lobe, average), 1e-4f);
}

HM_FN vec3 albedo_diffuse(HM_IN(DiffuseLobe) lobe, vec2 e) {
    HM_MAY_CONTRACT
    return lobe.color * (1.0f - albedo_layer(lobe, e));
}

// Disney's diffuse, relative to Lambert (Burley 2012).
HM_FN float burley_factor(float cos_o, float cos_i, float cos_d, float roughness) {
    float fd90 = 0.5f + 2.0f * roughness * cos_d * cos_d;
    return (1.0f + (fd90 - 1.0f) * pow5(1.0f - cos_o)) *
           (1.0f + (fd90 - 1.0f) * pow5(1.0f - cos_i));
}

// f, without the cosine. `e` is the mirror's split albedo towards wi and `loss` what it lacks to 1,
// both read with energy compensation only.
HM_FN vec3 eval_diffuse(HM_IN(DiffuseLobe) lobe, HM_IN(ScatterAngles) angles, float roughness,
                        vec2 e, float loss) {
    HM_MAY_CONTRACT
    float transmitted = 1.0f - (lobe.layer_f0 + (lobe.layer_f90 - lobe.layer_f0) * angles.grazing);
    if (params.energy_compensation != 0u)
        transmitted = lobe.scale * (1.0f - lobe.layer_f0 * e.x - lobe.layer_f90 * e.y -
                                    loss * lobe.layer_multiple);
    if (params.diffuse_kind == kDiffuseBurley)
        transmitted =
            transmitted * burley_factor(angles.cos_o, angles.cos_i, angles.cos_d, roughness);
    return lobe.color * (transmitted * kInvPi);
}

// Times the lobe's probability.
HM_FN float pdf_diffuse(HM_IN(DiffuseLobe) lobe, float cos_i) {
    HM_MAY_CONTRACT
    return lobe.probability * pdf_cosine_hemisphere(cos_i);
}

HM_FN vec3 sample_diffuse(float u, float v) {
    return sample_cosine_hemisphere(u, v);
}
