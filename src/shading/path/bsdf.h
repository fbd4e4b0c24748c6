// The glTF metallic-roughness material (glTF 2.0, Appendix B) as one mixture of a specular and a
// cosine lobe. With energy compensation the specular lobe gets its reciprocal multiple-scattering
// part (Kulla and Conty 2017; Fresnel series as Hill 2018), and the diffuse base is weighted by
// what the specular layer lets through in and out. Directions are local, z along the shading
// normal.
//
// Tables: albedo_table[32 * 32], albedo_average[32] (tools/make_albedo_table): the directional
// albedo of GGX is f0 * x + f90 * y; columns over sqrt(cos), rows over roughness.

HM_CONST uint kAlbedoSize = 32u;
HM_CONST float kMinRoughness = 0.04f;

struct Bsdf {
    vec3 diffuse;  // base colour times 1 - metallic
    vec3 f0;
    float f90;
    float alpha;
    float roughness;
    float layer_f0;  // the dielectric's Fresnel, over the diffuse base
    float layer_f90;
    float layer_multiple;  // albedo of the layer's multiple scattering
    float diffuse_scale;   // (1 - E_layer(wo)) / (1 - E_layer_avg)
    vec3 multiple;         // (1 - E(wo)) F_ms / (pi (1 - E_avg)); 0 without compensation
    float p_specular;      // probability of sampling the specular lobe
    float pdf_scale;       // ggx_reflection_pdf_scale
};

// x and y of the split albedo at a cosine.
HM_FN vec2 lookup_albedo(float cos_theta, float roughness) {
    HM_MAY_CONTRACT
    float last = float(kAlbedoSize - 1u);
    float column = fast_sqrt(saturate(cos_theta)) * last;
    float row = saturate(roughness) * last;
    uint c = min(uint(column), kAlbedoSize - 2u);
    uint r = min(uint(row), kAlbedoSize - 2u);
    float fc = column - float(c);
    float fr = row - float(r);
    uint i = r * kAlbedoSize + c;
    vec2 low = albedo_table[i] * (1.0f - fc) + albedo_table[i + 1u] * fc;
    vec2 high =
        albedo_table[i + kAlbedoSize] * (1.0f - fc) + albedo_table[i + kAlbedoSize + 1u] * fc;
    return low * (1.0f - fr) + high * fr;
}

HM_FN vec2 lookup_albedo_average(float roughness) {
    float row = saturate(roughness) * float(kAlbedoSize - 1u);
    uint r = min(uint(row), kAlbedoSize - 2u);
    float fr = row - float(r);
    return albedo_average[r] * (1.0f - fr) + albedo_average[r + 1u] * fr;
}

// Albedo of light that scattered more than once between microfacets, relative to what single
// scattering with a perfect mirror loses. The cosine-weighted mean of Schlick is f0 + (f90 - f0)
// / 21.
HM_FN float multiple_scattering(float f0, float f90, float e_average) {
    float f = f0 + (f90 - f0) / 21.0f;
    return f * f * e_average / (1.0f - f * (1.0f - e_average));
}

// base: linear colour; wo: the view direction, above the surface.
HM_FN void make_bsdf(vec3 base, float metallic, float roughness, float specular_weight, vec3 wo,
                     HM_OUT(Bsdf) b) {
    HM_MAY_CONTRACT
    b.roughness = clamp(roughness, kMinRoughness, 1.0f);
    b.alpha = b.roughness * b.roughness;
    b.layer_f0 = 0.04f * specular_weight;
    b.layer_f90 = specular_weight;
    b.diffuse = base * (1.0f - metallic);
    b.f0 = vec3(b.layer_f0) * (1.0f - metallic) + base * metallic;
    b.f90 = b.layer_f90 * (1.0f - metallic) + metallic;

    vec2 e_split = lookup_albedo(wo.z, b.roughness);
    float e = e_split.x + e_split.y;
    float layer = b.layer_f0 * e_split.x + b.layer_f90 * e_split.y;
    vec3 specular_albedo = b.f0 * e_split.x + vec3(b.f90 * e_split.y);
    vec3 cosine_albedo = b.diffuse * (1.0f - layer);
    b.layer_multiple = 0.0f;
    b.diffuse_scale = 1.0f;
    b.multiple = vec3(0.0f);
    if (params.energy_compensation != 0u) {
        vec2 average_split = lookup_albedo_average(b.roughness);
        float e_average = average_split.x + average_split.y;
        b.layer_multiple = multiple_scattering(b.layer_f0, b.layer_f90, e_average);
        float layer_average = b.layer_f0 * average_split.x + b.layer_f90 * average_split.y +
                              (1.0f - e_average) * b.layer_multiple;
        layer = layer + (1.0f - e) * b.layer_multiple;
        b.diffuse_scale = (1.0f - layer) / max(1.0f - layer_average, 1e-4f);
        vec3 lobe = vec3(b.layer_multiple);
        if (metallic > 0.0f) {
            vec3 metal = vec3(multiple_scattering(base.x, 1.0f, e_average),
                              multiple_scattering(base.y, 1.0f, e_average),
                              multiple_scattering(base.z, 1.0f, e_average));
            lobe = lobe * (1.0f - metallic) + metal * metallic;
        }
        b.multiple = lobe * ((1.0f - e) * kInvPi / max(1.0f - e_average, 1e-4f));
        cosine_albedo = b.diffuse * (1.0f - layer) + lobe * (1.0f - e);
    }
    float s = luminance(specular_albedo);
    float d = luminance(cosine_albedo);
    b.pdf_scale = ggx_reflection_pdf_scale(wo, b.alpha);
    b.p_specular = d > 0.0f ? 0.0f : 1.0f;
    if (s > 0.0f && d > 0.0f) b.p_specular = clamp(s / (s + d), 0.01f, 0.99f);
}

// Disney's diffuse, relative to Lambert (Burley 2012).
HM_FN float burley_factor(float cos_o, float cos_i, float cos_d, float roughness) {
    float fd90 = 0.5f + 2.0f * roughness * cos_d * cos_d;
    return (1.0f + (fd90 - 1.0f) * pow5(1.0f - cos_o)) *
           (1.0f + (fd90 - 1.0f) * pow5(1.0f - cos_i));
}

// f of either lobe, without the cosine, and the density of sampling wi from both. The directions
// are above the surface.
HM_FN void eval_lobes(HM_IN(Bsdf) b, vec3 wo, vec3 wi, HM_OUT(vec3) diffuse, HM_OUT(vec3) specular,
                      HM_OUT(float) pdf) {
    HM_MAY_CONTRACT
    pdf = 0.0f;
    vec3 h = fast_normalize(wo + wi);
    float cos_d = saturate(dot(wo, h));
    float grazing = pow5(1.0f - cos_d);
    specular = vec3(0.0f);
    if (b.p_specular > 0.0f) {
        vec3 fresnel = b.f0 + (vec3(b.f90) - b.f0) * grazing;
        float density = eval_ggx_d(h, b.alpha);
        specular = fresnel * (density * eval_ggx_v(wo.z, wi.z, b.alpha));
        pdf = b.p_specular * density * b.pdf_scale;
    }
    float transmitted = 1.0f - (b.layer_f0 + (b.layer_f90 - b.layer_f0) * grazing);
    if (params.energy_compensation != 0u) {
        vec2 e_split = lookup_albedo(wi.z, b.roughness);
        float loss = 1.0f - (e_split.x + e_split.y);  // as in make_bsdf, to the bit
        transmitted = b.diffuse_scale * (1.0f - b.layer_f0 * e_split.x - b.layer_f90 * e_split.y -
                                         loss * b.layer_multiple);
        specular = specular + b.multiple * loss;
    }
    if (params.diffuse_kind == kDiffuseBurley)
        transmitted = transmitted * burley_factor(wo.z, wi.z, cos_d, b.roughness);
    diffuse = b.diffuse * (transmitted * kInvPi);
    pdf = pdf + (1.0f - b.p_specular) * pdf_cosine_hemisphere(wi.z);
}

// f cos for wi, and the density of sampling it. Zero when either direction is below the surface.
HM_FN vec3 eval_bsdf(HM_IN(Bsdf) b, vec3 wo, vec3 wi, HM_OUT(float) pdf) {
    pdf = 0.0f;
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    vec3 diffuse;
    vec3 specular;
    eval_lobes(b, wo, wi, diffuse, specular, pdf);
    return (specular + diffuse) * wi.z;
}

// The diffuse lobe's part of f, 0 where there is none.
HM_FN vec3 diffuse_share(HM_IN(Bsdf) b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    vec3 diffuse;
    vec3 specular;
    float pdf;
    eval_lobes(b, wo, wi, diffuse, specular, pdf);
    return diffuse / max(specular + diffuse, vec3(1e-30f));
}

// A direction from the mixture of lobes; may point below the surface, where eval_bsdf gives zero.
HM_FN vec3 sample_bsdf(HM_IN(Bsdf) b, vec3 wo, float lobe, float u, float v) {
    if (lobe < b.p_specular) return sample_ggx_reflection(wo, b.alpha, u, v);
    return sample_cosine_hemisphere(u, v);
}
