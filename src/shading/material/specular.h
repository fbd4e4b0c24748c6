// The specular lobe: GGX reflection with Schlick's Fresnel (glTF 2.0, Appendix B; Schlick is linear
// in f0 and f90, so one lobe serves dielectric, metal and their mix). With energy compensation it
// has a reciprocal multiple-scattering part (Kulla and Conty 2017, Fresnel series as Hill 2018),
// which is sampled by the diffuse lobe's cosine. Directions are local, z along the shading normal.

HM_CONST float kMinRoughness = 0.04f;
HM_CONST float kDielectricF0 = 0.04f;

struct SpecularLobe {
    vec3 f0;
    float f90;
    float roughness;
    float alpha;
    vec3 multiple;      // (1 - E(wo)) F_ms / (pi (1 - E_avg)); 0 without compensation
    float pdf_scale;    // ggx_reflection_pdf_scale of wo
    float probability;  // of sampling this lobe
};

// Single scattering only; the mixture sets the probability.
HM_FN void make_specular(HM_IN(MaterialPoint) m, vec3 wo, HM_OUT(SpecularLobe) lobe) {
    HM_MAY_CONTRACT
    lobe.roughness = clamp(m.roughness, kMinRoughness, 1.0f);
    lobe.alpha = lobe.roughness * lobe.roughness;
    lobe.f0 =
        vec3(kDielectricF0 * m.specular_weight) * (1.0f - m.metallic) + m.base_color * m.metallic;
    lobe.f90 = m.specular_weight * (1.0f - m.metallic) + m.metallic;
    lobe.multiple = vec3(0.0f);
    lobe.pdf_scale = ggx_reflection_pdf_scale(wo, lobe.alpha);
    lobe.probability = 0.0f;
}

// Adds multiple scattering, given the mirror's albedo towards wo and on average, and F_ms of the
// dielectric. Returns the albedo that this adds.
HM_FN vec3 compensate_specular(HM_IN(MaterialPoint) m, float e, float e_average,
                               float dielectric_multiple, HM_INOUT(SpecularLobe) lobe) {
    HM_MAY_CONTRACT
    vec3 f_ms = vec3(dielectric_multiple);
    if (m.metallic > 0.0f) {
        vec3 metal = vec3(multiple_fresnel(m.base_color.x, 1.0f, e_average),
                          multiple_fresnel(m.base_color.y, 1.0f, e_average),
                          multiple_fresnel(m.base_color.z, 1.0f, e_average));
        f_ms = f_ms * (1.0f - m.metallic) + metal * m.metallic;
    }
    lobe.multiple = f_ms * ((1.0f - e) * kInvPi / max(1.0f - e_average, 1e-4f));
    return f_ms * (1.0f - e);
}

// Single scattering's; `e` is the split albedo towards wo.
HM_FN vec3 albedo_specular(HM_IN(SpecularLobe) lobe, vec2 e) {
    HM_MAY_CONTRACT
    return lobe.f0 * e.x + vec3(lobe.f90 * e.y);
}

// f, without the cosine. `density` is eval_ggx_d, `loss` what the mirror's albedo towards wi lacks
// to 1.
HM_FN vec3 eval_specular(HM_IN(SpecularLobe) lobe, HM_IN(ScatterAngles) angles, float density,
                         float loss) {
    HM_MAY_CONTRACT
    vec3 f = vec3(0.0f);
    if (lobe.probability > 0.0f) {
        vec3 fresnel = lobe.f0 + (vec3(lobe.f90) - lobe.f0) * angles.grazing;
        f = fresnel * (density * eval_ggx_v(angles.cos_o, angles.cos_i, lobe.alpha));
    }
    return f + lobe.multiple * loss;
}

// Times the lobe's probability.
HM_FN float pdf_specular(HM_IN(SpecularLobe) lobe, float density) {
    HM_MAY_CONTRACT
    return lobe.probability * density * lobe.pdf_scale;
}

HM_FN vec3 sample_specular(HM_IN(SpecularLobe) lobe, vec3 wo, float u, float v) {
    return sample_ggx_reflection(wo, lobe.alpha, u, v);
}
