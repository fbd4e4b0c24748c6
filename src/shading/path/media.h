// The media that a path is inside: a stack of volumes that it entered and has not left
// (KHR_materials_volume), in four slots of 15 bits, and its channel once it was dispersed.
//
// Overlapping volumes: what was entered last counts. A path that leaves another volume than that
// crosses no boundary. So a glass of water, with the water's mesh reaching into the glass, has one
// boundary between water and glass. A path that leaves a volume it never entered (the camera is
// inside) was in that volume all along. The fifth volume makes a path forget the first.
//
// Tables: materials' rows in extended_materials.

HM_CONST uint kMediumMask = 32767u;

// 1 + the row of the volume entered last; 0: none.
HM_FN uint top_medium(uvec2 media) {
    return media.x & kMediumMask;
}

// No channel yet: 0; then 1 to 3, red to blue.
HM_FN uint path_channel(uvec2 media) {
    return media.y >> 30u;
}

HM_FN uvec2 with_channel(uvec2 media, uint channel) {
    return uvec2(media.x, (media.y & 0x3fffffffu) | (channel << 30u));
}

HM_FN uvec2 enter_medium(uvec2 media, uint medium) {
    uint x = (media.x << 15u) | medium;
    uint y = (media.y << 15u) | ((media.x >> 15u) & kMediumMask);
    return uvec2(x & 0x3fffffffu, (y & 0x3fffffffu) | (media.y & 0xc0000000u));
}

// The slot of a medium, counted from the top; 4: the path is not inside it.
HM_FN uint medium_slot(uvec2 media, uint medium) {
    if ((media.x & kMediumMask) == medium) return 0u;
    if (((media.x >> 15u) & kMediumMask) == medium) return 1u;
    if ((media.y & kMediumMask) == medium) return 2u;
    return ((media.y >> 15u) & kMediumMask) == medium ? 3u : 4u;
}

// Closes the gap that the medium leaves.
HM_FN uvec2 leave_medium(uvec2 media, uint medium) {
    uint slot = medium_slot(media, medium);
    uint channel = media.y & 0xc0000000u;
    uint third = media.y & kMediumMask;
    uint fourth = (media.y >> 15u) & kMediumMask;
    if (slot == 4u) return media;
    if (slot == 3u) return uvec2(media.x, third | channel);
    if (slot == 2u) return uvec2(media.x, fourth | channel);
    uint first = slot == 0u ? (media.x >> 15u) & kMediumMask : media.x & kMediumMask;
    return uvec2(first | (third << 15u), fourth | channel);
}

// What the ray that ends on this surface went through.
HM_FN uint medium_before(uvec2 media, HM_IN(MaterialData) m, bool front) {
    if (front || (m.flags & kMaterialVolume) == 0u) return top_medium(media);
    uint medium = extended_row(m) + 1u;
    return medium_slot(media, medium) == 4u ? medium : top_medium(media);
}

HM_FN uvec2 media_beyond(uvec2 media, HM_IN(MaterialData) m, bool front) {
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
