// AOVs: what closest hit writes to the payload, mostly for camera rays only. closest_hit.h includes
// this with HM_AOVS, and aov_facts_off.h without.

// An unlit surface is rough and has its own colour.
HM_FN void note_surface(HM_INOUT(PathPayload) p, HM_IN(HitIds) ids, HM_IN(Surface) s) {
    p.emitted_source = material_source(s.material);
    if (p.bounce != 0u) return;
    p.facts.ids = ids;
    p.facts.material = s.material;
    p.facts.geometry = s.geometry;
    p.facts.weights = s.weights;
    p.facts.uv = s.uv0;
    p.facts.position = s.position;
    p.facts.ns = s.ns;
    p.facts.ng = s.ng;
    p.facts.albedo = min(p.emitted, vec3(1.0f));
    p.facts.metallic = 0.0f;
    p.facts.roughness = 1.0f;
}

// The albedo that denoisers and compositors expect; for metals it is the specular colour.
HM_FN void note_material(HM_INOUT(PathPayload) p, HM_IN(Bsdf) b, float metallic) {
    if (p.bounce != 0u) return;
    p.facts.albedo = min(b.diffuse.color + b.specular.f0, vec3(1.0f));
    p.facts.metallic = metallic;
    p.facts.roughness = b.specular.roughness;
}

HM_FN void note_light_sample(HM_INOUT(PathPayload) p, HM_IN(Bsdf) b, vec3 wo, vec3 wi,
                             uint source) {
    p.light_source = source;
    if (p.bounce == 0u) p.light_diffuse_share = diffuse_share(b, wo, wi);
}

HM_FN void note_scatter(HM_INOUT(PathPayload) p, HM_IN(Bsdf) b, vec3 wo, vec3 wi) {
    if (p.bounce == 0u) p.diffuse_share = diffuse_share(b, wo, wi);
}

#ifdef HM_EXTENDED
// The same for extended materials. Glass has the colour that it tints.
HM_FN void note_extended(HM_INOUT(PathPayload) p, vec3 albedo, float metallic, float roughness) {
    if (p.bounce != 0u) return;
    p.facts.albedo = min(albedo, vec3(1.0f));
    p.facts.metallic = metallic;
    p.facts.roughness = roughness;
}

// `diffuse` is the diffuse lobes' part of f.
HM_FN void note_extended_light(HM_INOUT(PathPayload) p, vec3 diffuse, vec3 f, uint source) {
    p.light_source = source;
    if (p.bounce == 0u) p.light_diffuse_share = diffuse / max(f, vec3(1e-30f));
}

HM_FN void note_extended_scatter(HM_INOUT(PathPayload) p, HM_IN(ExtendedSample) s) {
    if (p.bounce == 0u) p.diffuse_share = s.diffuse / max(s.weight, vec3(1e-30f));
}
#endif
