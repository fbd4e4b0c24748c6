// The BSDF of materials with extensions. From the top: coat, sheen, then the metal or a dielectric,
// which is opaque (specular layer over diffuse base) or glass. A layer lets through what its
// tabulated albedo towards wo leaves: energy is kept, reciprocity is not (docs/shading.md).
//
// The side of the surface is drawn first; light and BSDF sampling then are about that side alone,
// and their values are divided by its probability. Directions are local, wo above the surface.
//
// Tables: those of albedo.h and energy.h.

// The density of directions that have no density: light sampling never finds them.
HM_CONST float kDeltaPdf = 1e20f;

struct ExtendedBsdf {
    ExtendedSpecular specular;
    vec3 diffuse;  // albedo, without the factors of eval_extended_diffuse
    vec3 diffuse_transmitted;
    float layer_f0;  // of the dielectric, read without energy compensation
    float layer_f90;
    vec3 sheen;
    float sheen_roughness;
    float roughness;
    CoatLobe coat;
    float transmits;  // the probability of the far side
    // Of sampling a lobe once the side is known; the diffuse lobes have the rest.
    float coat_probability;
    float sheen_probability;
    float specular_probability;
    float pane_probability;
};

// Splits the base below coat and sheen, which has this share of the light. `e` is the split albedo
// of the mirror.
HM_FN void make_extended_base(HM_IN(MaterialPoint) m, HM_IN(ExtendedPoint) p, vec3 wo, vec2 e,
                              float share, HM_INOUT(ExtendedBsdf) b, HM_OUT(vec2) glass) {
    HM_MAY_CONTRACT
    vec3 f0 = film_f0(p, dielectric_f0(p, normal_reflectance(max(p.ior, 1e-3f))), wo.z);
    float f90 = dielectric_f90(p);
    vec3 back = compensation(f0, e);
    float dielectric = 1.0f - m.metallic;
    float opaque = dielectric * (1.0f - p.transmission) * share;
    vec3 metal_f0 = film_f0(p, m.base_color, wo.z);
    vec3 metal = compensation(metal_f0, e) * (m.metallic * share);
    b.specular.f0 = f0 * back * opaque + metal_f0 * metal;
    b.specular.f90 = back * (f90 * opaque) + metal;

    b.layer_f0 = max_component(f0);
    b.layer_f90 = f90;
    float passed = 1.0f;
    if (params.energy_compensation != 0u)
        passed = max(1.0f - max_component(back * (f0 * e.x + vec3(f90 * e.y))), 0.0f);
    b.diffuse = m.base_color * (opaque * passed * (1.0f - p.diffuse_transmission));
    b.diffuse_transmitted =
        p.diffuse_transmission_color * (opaque * passed * p.diffuse_transmission);

    glass = vec2(0.0f);
    b.specular.glass = dielectric * p.transmission * share;
    if (!(b.specular.glass > 0.0f)) return;
    b.specular.glass_f0 = film_f0(p, dielectric_f0(p, normal_reflectance(b.specular.eta)), wo.z);
    b.specular.glass_f90 = vec3(f90);
    vec2 shares = glass_shares(b.specular, wo, e.x + e.y);
    if (params.energy_compensation != 0u)
        b.specular.glass = b.specular.glass / max(shares.x + shares.y, 1e-3f);
    glass = colored_shares(b.specular, shares, e.x + e.y) * b.specular.glass;
}

HM_FN void set_extended_probabilities(vec2 mirrored, vec2 glass, float sheen,
                                      HM_INOUT(ExtendedBsdf) b) {
    HM_MAY_CONTRACT
    float coat = 1.0f - b.coat.passage;
    float specular = luminance(b.specular.f0 * mirrored.x + b.specular.f90 * mirrored.y) + glass.x;
    float reflected = coat + sheen + specular + luminance(b.diffuse);
    float pane = glass.y * luminance(b.specular.tint);
    float through = pane + luminance(b.diffuse_transmitted);
    b.transmits = through > 0.0f ? 1.0f : 0.0f;
    if (through > 0.0f && reflected > 0.0f)
        b.transmits = clamp(through / (through + reflected), 0.05f, 0.95f);
    float scale = reflected > 0.0f ? 1.0f / reflected : 0.0f;
    b.coat_probability = coat * scale;
    b.sheen_probability = sheen * scale;
    b.specular_probability = specular * scale;
    if (!(luminance(b.diffuse) > 0.0f))
        b.specular_probability = 1.0f - b.coat_probability - b.sheen_probability;
    b.pane_probability = through > 0.0f ? pane / through : 0.0f;
}

// wo is above the surface; `coat_normal` is local; `eta` the index beyond the boundary over that
// on wo's side; thin walls refract nothing.
HM_FN void make_extended_bsdf(HM_IN(MaterialPoint) m, HM_IN(ExtendedPoint) p, vec3 wo,
                              vec3 coat_normal, float eta, bool thin, HM_OUT(ExtendedBsdf) b) {
    HM_MAY_CONTRACT
    b.roughness = clamp(m.roughness, kMinRoughness, 1.0f);
    b.specular.alpha = highlight_alpha(b.roughness, p.anisotropy);
    b.specular.pdf_scale = anisotropic_reflection_pdf_scale(wo, b.specular.alpha);
    b.specular.mirror = p.transmission > 0.0f && m.roughness < kMinRoughness;
    b.specular.eta = eta;
    b.specular.thin = thin;
    b.specular.pane = b.specular.mirror || (!thin && abs(eta - 1.0f) < 1e-3f);
    b.specular.tint = m.base_color;
    b.specular.glass_f0 = vec3(0.0f);
    b.specular.glass_f90 = vec3(0.0f);

    make_coat(p.clearcoat, p.clearcoat_roughness, coat_normal, wo, b.coat);
    b.sheen = p.sheen_color * b.coat.passage;
    b.sheen_roughness = p.sheen_roughness;
    float share = b.coat.passage;
    float sheen = 0.0f;
    if (max_component(p.sheen_color) > 0.0f) {
        float excess = lookup_sheen_albedo(wo.z, p.sheen_roughness);
        float albedo = min(excess, 1.0f);
        b.sheen = b.sheen * (albedo / max(excess, 1e-6f));
        sheen = luminance(b.sheen) * excess;
        share = share * (1.0f - max_component(p.sheen_color) * albedo);
    }
    vec2 e = mirror_albedo(b.specular, wo, b.roughness, p.anisotropy);
    vec2 glass;
    make_extended_base(m, p, wo, e, share, b, glass);
    set_extended_probabilities(e, glass, sheen, b);
}

// The diffuse lobe's f cos_i on wo's side.
HM_FN vec3 eval_extended_diffuse(HM_IN(ExtendedBsdf) b, vec3 wo, vec3 wi) {
    HM_MAY_CONTRACT
    float factor = kInvPi * wi.z;
    float cos_d = saturate(dot(wo, fast_normalize(wo + wi)));
    if (params.energy_compensation == 0u)
        factor = factor * (1.0f - (b.layer_f0 + (b.layer_f90 - b.layer_f0) * pow5(1.0f - cos_d)));
    if (params.diffuse_kind == kDiffuseBurley)
        factor = factor * burley_factor(wo.z, wi.z, cos_d, b.roughness);
    return b.diffuse * factor;
}

// f cos_i on wo's side, its diffuse part, and the density of sampling wi; without delta functions.
HM_FN vec3 eval_extended_reflection(HM_IN(ExtendedBsdf) b, vec3 wo, vec3 wi, HM_OUT(vec3) diffuse,
                                    HM_OUT(float) pdf) {
    HM_MAY_CONTRACT
    float density;
    float rest = 1.0f - b.coat_probability - b.sheen_probability - b.specular_probability;
    diffuse = eval_extended_diffuse(b, wo, wi);
    pdf = rest * pdf_cosine_hemisphere(wi.z);
    if (max_component(b.sheen) > 0.0f) {
        diffuse = diffuse + b.sheen * (eval_sheen(wo, wi, b.sheen_roughness) * wi.z);
        pdf = pdf + b.sheen_probability * (0.5f * kInvPi);
    }
    vec3 f = diffuse + vec3(eval_coat(b.coat, wi, density));
    pdf = pdf + b.coat_probability * density;
    if (b.specular.mirror) return f;
    float cos_d;
    float value = eval_extended_ggx(b.specular, wo, wi, density, cos_d);
    pdf = pdf + b.specular_probability * density;
    return f + reflected_fresnel(b.specular, cos_d) * value;
}

// The same on the far side.
HM_FN vec3 eval_extended_far(HM_IN(ExtendedBsdf) b, vec3 wo, vec3 wi, HM_OUT(vec3) diffuse,
                             HM_OUT(float) pdf) {
    HM_MAY_CONTRACT
    diffuse = b.diffuse_transmitted * (-wi.z * kInvPi);
    pdf = (1.0f - b.pane_probability) * pdf_cosine_hemisphere(-wi.z);
    if (b.specular.pane || !(b.specular.glass > 0.0f)) return diffuse;
    float density;
    vec3 f = eval_extended_transmission(b.specular, wo, wi, density);
    pdf = pdf + b.pane_probability * density;
    return diffuse + f;
}

// f cos_i of the side that was drawn, over the side's probability, and the density of sampling wi
// once the side is known. Zero for directions on the other side.
HM_FN vec3 eval_extended(HM_IN(ExtendedBsdf) b, bool far, vec3 wo, vec3 wi, HM_OUT(vec3) diffuse,
                         HM_OUT(float) pdf) {
    diffuse = vec3(0.0f);
    pdf = 0.0f;
    if (!(wo.z > 0.0f)) return vec3(0.0f);
    vec3 f = vec3(0.0f);
    if (far && wi.z < 0.0f) f = eval_extended_far(b, wo, wi, diffuse, pdf);
    if (!far && wi.z > 0.0f) f = eval_extended_reflection(b, wo, wi, diffuse, pdf);
    float side = 1.0f / max(far ? b.transmits : 1.0f - b.transmits, 1e-6f);
    diffuse = diffuse * side;
    return f * side;
}

struct ExtendedSample {
    vec3 wi;
    vec3 weight;   // f cos_i over the density, sides included
    vec3 diffuse;  // its diffuse part
    float pdf;     // kDeltaPdf for delta functions; 0: no direction
};

// A direction that the specular lobe reflects or lets through as a delta function.
HM_FN void sample_extended_delta(HM_IN(ExtendedBsdf) b, bool far, vec3 wo,
                                 HM_OUT(ExtendedSample) s) {
    s.wi = vec3(-wo.x, -wo.y, wo.z);
    if (far) s.wi = sample_extended_transmission(b.specular, wo, 0.0f, 0.0f);
    s.diffuse = vec3(0.0f);
    s.pdf = kDeltaPdf;
    vec3 f = far ? transmitted_fresnel(b.specular, wo.z) : reflected_fresnel(b.specular, wo.z);
    float p =
        far ? b.transmits * b.pane_probability : (1.0f - b.transmits) * b.specular_probability;
    s.weight = f / max(p, 1e-6f);
    if (dot(s.wi, s.wi) < 0.5f) s.pdf = 0.0f;
}

// `lobe`, u and v in [0, 1) pick a lobe of the side and a direction.
HM_FN void sample_extended(HM_IN(ExtendedBsdf) b, bool far, vec3 wo, float lobe, float u, float v,
                           HM_OUT(ExtendedSample) s) {
    float coat_end = b.coat_probability;
    float sheen_end = coat_end + b.sheen_probability;
    float specular_end = sheen_end + b.specular_probability;
    bool glass = far && lobe < b.pane_probability;
    bool specular = !far && lobe >= sheen_end && lobe < specular_end;
    if ((glass && b.specular.pane) || (specular && b.specular.mirror)) {
        sample_extended_delta(b, far, wo, s);
        return;
    }
    s.wi = sample_diffuse(u, v);
    if (glass) {
        s.wi = sample_extended_transmission(b.specular, wo, u, v);
    } else if (far) {
        s.wi.z = -s.wi.z;
    } else if (specular) {
        s.wi = sample_anisotropic_reflection(wo, b.specular.alpha, u, v);
    } else if (lobe < coat_end) {
        s.wi = sample_coat(b.coat, u, v);
    } else if (lobe < sheen_end) {
        s.wi = sample_uniform_hemisphere(u, v);
    }
    vec3 diffuse;
    vec3 f = eval_extended(b, far, wo, s.wi, diffuse, s.pdf);
    float inverse = s.pdf > 0.0f ? 1.0f / s.pdf : 0.0f;
    s.weight = f * inverse;
    s.diffuse = diffuse * inverse;
}
