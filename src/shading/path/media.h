// The media that a path is inside: a stack of volumes that it entered and has not left
// (KHR_materials_volume), in three slots of ten bits, and its channel once it was dispersed.
//
// Overlapping volumes: what was entered last counts. A path that leaves another volume than that
// crosses no boundary. So a glass of water, with the water's mesh reaching into the glass, has one
// boundary between water and glass. A path that leaves a volume it never entered (the camera is
// inside) was in that volume all along. The fourth volume makes a path forget the first.
//
// Tables: materials' rows in extended_materials.

HM_CONST uint kMediumBits = 10u;
HM_CONST uint kChannelShift = 30u;

// 1 + the row of the volume entered last; 0: none.
HM_FN uint top_medium(uint media) {
    return media & kMaxVolumes;
}

// No channel yet: 0; then 1 to 3, red to blue.
HM_FN uint path_channel(uint media) {
    return media >> kChannelShift;
}

HM_FN uint with_channel(uint media, uint channel) {
    return (media & 0x3fffffffu) | (channel << kChannelShift);
}

HM_FN uint enter_medium(uint media, uint medium) {
    return with_channel((media << kMediumBits) | medium, path_channel(media));
}

// The first bit of a medium's slot; 30: the path is not inside it.
HM_FN uint medium_shift(uint media, uint medium) {
    if ((media & kMaxVolumes) == medium) return 0u;
    if (((media >> kMediumBits) & kMaxVolumes) == medium) return kMediumBits;
    return ((media >> (2u * kMediumBits)) & kMaxVolumes) == medium ? 2u * kMediumBits : 30u;
}

// Closes the gap that the medium leaves.
HM_FN uint leave_medium(uint media, uint medium) {
    uint shift = medium_shift(media, medium);
    if (shift == 30u) return media;
    uint above = media & ((1u << shift) - 1u);
    uint below = ((media & 0x3fffffffu) >> (shift + kMediumBits)) << shift;
    return with_channel(above | below, path_channel(media));
}

// What the ray that ends on this surface went through.
HM_FN uint medium_before(uint media, HM_IN(MaterialData) m, bool front) {
    if (front || (m.flags & kMaterialVolume) == 0u) return top_medium(media);
    uint medium = extended_row(m) + 1u;
    return medium_shift(media, medium) == 30u ? medium : top_medium(media);
}

HM_FN uint media_beyond(uint media, HM_IN(MaterialData) m, bool front) {
    if ((m.flags & kMaterialVolume) == 0u) return media;
    uint medium = extended_row(m) + 1u;
    return front ? enter_medium(media, medium) : leave_medium(media, medium);
}

// Index of refraction, of a channel (KHR_materials_dispersion: red is refracted least).
HM_FN float medium_ior(uint medium, uint channel) {
    if (medium == 0u) return 1.0f;
    HM_ROW(ExtendedMaterialData) x = extended_materials[medium - 1u];
    if (!(x.ior > 0.0f)) return 1000.0f;  // ior 0: reflects everything
    if (channel == 0u) return x.ior;
    float spread = (x.ior - 1.0f) * 0.025f * x.dispersion;
    return max(x.ior + (float(channel) - 2.0f) * spread, min(x.ior, 1.0f));
}

// Beer and Lambert: what is left after a distance. Rays to infinity keep their light.
HM_FN vec3 transmittance(uint medium, float distance) {
    HM_MAY_CONTRACT
    if (medium == 0u || distance >= kInfinity) return vec3(1.0f);
    HM_ROW(ExtendedMaterialData) x = extended_materials[medium - 1u];
    float lengths = distance / max(x.attenuation_distance, 1e-30f);
    vec3 color = max(x.attenuation_color, vec3(1e-20f));
    return exp2(log2(color) * lengths);
}

// Takes from what a hit scatters what media absorb: before it, and on the way to the light.
HM_FN void attenuate(HM_INOUT(PathPayload) p, vec3 passed) {
    p.weight = p.weight * passed;
    p.light_contribution =
        p.light_contribution * passed * transmittance(top_medium(p.media), p.light_distance);
}
