// The specular part of an extended material: one GGX distribution whose reflection is that of
// dielectric, metal and glass together, with index, colour, film and anisotropy applied.

// A GGX lobe that scatters by (f0, f90) after Schlick, plus glass by the exact Fresnel equations.
// All weights are applied: f = D V (f0 + (f90 - f0) grazing + glass F).
struct ExtendedSpecular {
    vec2 alpha;
    vec3 f0;
    vec3 f90;
    float glass;
    vec3 glass_f0;
    vec3 glass_f90;
    float eta;        // index beyond the boundary over that on wo's side
    vec3 tint;        // of transmitted light
    bool thin;        // light passes straight on, as if by two boundaries
    bool mirror;      // reflection is a delta function
    bool pane;        // transmission is one
    float pdf_scale;  // anisotropic_reflection_pdf_scale of wo
};

// Ends of the dielectric's Fresnel curve, for a reflectance at normal incidence.
HM_FN vec3 dielectric_f0(HM_IN(ExtendedPoint) p, float reflectance) {
    if (p.glossy) return min(p.specular_color, vec3(1.0f));
    return min(reflectance * p.specular_color, vec3(1.0f)) * p.specular;
}

HM_FN float dielectric_f90(HM_IN(ExtendedPoint) p) {
    return p.glossy ? 1.0f : p.specular;
}

// f0 under the film: the one of Schlick's curve that has the film's reflectance at this cosine.
HM_FN vec3 film_f0(HM_IN(ExtendedPoint) p, vec3 f0, float cosine) {
    HM_MAY_CONTRACT
    if (!(p.iridescence > 0.0f)) return f0;
    vec3 f = thin_film_fresnel(p.iridescence_ior, p.iridescence_thickness, f0, cosine);
    float grazing = pow5(1.0f - saturate(cosine));
    vec3 film = clamp((f - vec3(grazing)) / max(1.0f - grazing, 1e-4f), vec3(0.0f), vec3(1.0f));
    return f0 + (film - f0) * p.iridescence;
}

// The factor that gives light back that single scattering loses, for a split albedo e of the mirror
// (Turquin, "Practical Multiple Scattering Compensation for Microfacet Models", 2019).
HM_FN vec3 compensation(vec3 f0, vec2 e) {
    HM_MAY_CONTRACT
    if (params.energy_compensation == 0u) return vec3(1.0f);
    float sum = max(e.x + e.y, 1e-3f);
    return vec3(1.0f) + f0 * ((1.0f - sum) / sum);
}

// Widths of the highlight along x and y (KHR_materials_anisotropy).
HM_FN vec2 highlight_alpha(float roughness, float anisotropy) {
    float alpha = roughness * roughness;
    return vec2(alpha + (1.0f - alpha) * anisotropy * anisotropy, alpha);
}

// The split albedo of the mirror towards wo.
HM_FN vec2 mirror_albedo(HM_IN(ExtendedSpecular) lobe, vec3 wo, float roughness, float anisotropy) {
    float grazing = pow5(1.0f - saturate(wo.z));
    if (lobe.mirror) return vec2(1.0f - grazing, grazing);
    if (anisotropy > 0.0f) return lookup_anisotropic_albedo(wo, roughness, anisotropy);
    return lookup_albedo(wo.z, roughness);
}

// The glass's reflected and transmitted share of one scattering event; `mirrored` is the albedo of
// the mirror.
HM_FN vec2 glass_shares(HM_IN(ExtendedSpecular) lobe, vec3 wo, float mirrored) {
    HM_MAY_CONTRACT
    if (lobe.mirror) {
        float cos_t;
        float r = fresnel_dielectric(wo.z, lobe.eta, cos_t);
        return vec2(r, 1.0f - r);
    }
    float alpha = fast_sqrt(lobe.alpha.x * lobe.alpha.y);
    vec2 shares = lookup_glass_albedo(wo.z, fast_sqrt(alpha), lobe.eta);
    if (lobe.thin) shares.y = max(mirrored - shares.x, 0.0f);
    return shares;
}

// The same with the lobe's own ends of the Fresnel curve, colour and film included: what directions
// are drawn by.
HM_FN vec2 colored_shares(HM_IN(ExtendedSpecular) lobe, vec2 shares, float mirrored) {
    HM_MAY_CONTRACT
    float r0 = normal_reflectance(lobe.eta);
    float f0 = luminance(lobe.glass_f0);
    float grazing = max(shares.x - r0 * mirrored, 0.0f) / max(1.0f - r0, 1e-6f);
    float both = shares.x + shares.y;
    float reflected = clamp(f0 * mirrored + (lobe.glass_f90.x - f0) * grazing, 0.0f, both);
    return vec2(reflected, both - reflected);
}

// The glass's Fresnel factor at a microfacet.
HM_FN vec3 glass_fresnel(HM_IN(ExtendedSpecular) lobe, float cos_d) {
    float cos_t;
    float r = fresnel_dielectric(cos_d, lobe.eta, cos_t);
    if (!(cos_t > 0.0f)) return vec3(1.0f);
    return fresnel_between(lobe.glass_f0, lobe.glass_f90, r, lobe.eta);
}

// What one microfacet reflects.
HM_FN vec3 reflected_fresnel(HM_IN(ExtendedSpecular) lobe, float cos_d) {
    HM_MAY_CONTRACT
    vec3 f = lobe.f0 + (lobe.f90 - lobe.f0) * pow5(1.0f - saturate(cos_d));
    if (lobe.glass > 0.0f) f = f + glass_fresnel(lobe, cos_d) * lobe.glass;
    return f;
}

// What one microfacet lets through: what the strongest colour leaves.
HM_FN vec3 transmitted_fresnel(HM_IN(ExtendedSpecular) lobe, float cos_d) {
    return lobe.tint * (lobe.glass * max(1.0f - max_component(glass_fresnel(lobe, cos_d)), 0.0f));
}

// Reflection by D V: f cos_i, and the density of sampling it. `fresnel_cosine` is what the caller's
// Fresnel factor is taken at.
HM_FN float eval_extended_ggx(HM_IN(ExtendedSpecular) lobe, vec3 wo, vec3 wi, HM_OUT(float) pdf,
                              HM_OUT(float) fresnel_cosine) {
    HM_MAY_CONTRACT
    vec3 h = fast_normalize(wo + wi);
    float d = eval_anisotropic_d(h, lobe.alpha);
    pdf = d * lobe.pdf_scale;
    fresnel_cosine = saturate(dot(wo, h));
    return d * wi.z *
           eval_smith_v(wo.z, stretched_length(wo, lobe.alpha), wi.z,
                        stretched_length(wi, lobe.alpha));
}

// Light that the boundary lets through: f cos_i, and the density of sampling it. For rough glass.
HM_FN vec3 eval_extended_transmission(HM_IN(ExtendedSpecular) lobe, vec3 wo, vec3 wi,
                                      HM_OUT(float) pdf) {
    float cos_d;
    float value;
    if (lobe.thin)
        value = eval_extended_ggx(lobe, wo, vec3(wi.x, wi.y, -wi.z), pdf, cos_d);
    else
        value = eval_refraction(wo, wi, lobe.alpha, lobe.eta, pdf, cos_d);
    if (!(value > 0.0f)) return vec3(0.0f);
    return transmitted_fresnel(lobe, cos_d) * value;
}

// The direction of transmitted light; 0 under total reflection.
HM_FN vec3 sample_extended_transmission(HM_IN(ExtendedSpecular) lobe, vec3 wo, float u, float v) {
    if (lobe.thin) {
        vec3 wi = vec3(-wo.x, -wo.y, wo.z);
        if (!lobe.mirror) wi = sample_anisotropic_reflection(wo, lobe.alpha, u, v);
        return vec3(wi.x, wi.y, -wi.z);
    }
    vec3 h = vec3(0.0f, 0.0f, 1.0f);
    if (!lobe.pane) h = sample_visible_normal(wo, lobe.alpha, 1.0f, u, v);
    return refract_about(wo, h, lobe.eta);
}
