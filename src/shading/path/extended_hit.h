// Closest hit on a material with extensions. The side of the surface is drawn first: the light
// sample and the next direction are on that side, in the media there.

struct ExtendedShading {
    Frame frame;
    vec3 ng;  // on the side that was drawn
    vec3 wo;
    bool far;
    vec3 channels;  // 1, or 3 for the channel that dispersion chose
};

HM_FN void shade_extended_light(HM_INOUT(PathPayload) p, HM_IN(ExtendedBsdf) b,
                                HM_IN(ExtendedShading) at, HM_IN(uvec4) numbers) {
    HM_MAY_CONTRACT
    LightSample light;
    sample_light(numbers.x, numbers.y, unit_float(numbers.z), unit_float(numbers.w), p.next_origin,
                 light);
    if (!(light.pdf > 0.0f) || dot(light.wi, at.ng) <= 0.0f) return;
    vec3 diffuse;
    float pdf_bsdf;
    vec3 f = eval_extended(b, at.far, at.wo, to_local(at.frame, light.wi), diffuse, pdf_bsdf);
    float weight = 1.0f;
    if (!light.punctual && params.strategy == kStrategyMis)
        weight = mis_weight(light.pdf, pdf_bsdf);
    p.light_direction = light.wi;
    p.light_distance = light.distance;
    p.light_contribution = f * at.channels * light.radiance * (weight / light.pdf);
    note_extended_light(p, diffuse, f, light.source);
}

HM_FN void shade_extended_scatter(HM_INOUT(PathPayload) p, HM_IN(ExtendedBsdf) b,
                                  HM_IN(ExtendedShading) at, float lobe, HM_IN(uvec4) numbers) {
    ExtendedSample drawn;
    sample_extended(b, at.far, at.wo, lobe, unit_float(numbers.y), unit_float(numbers.z), drawn);
    p.next_direction = to_world(at.frame, drawn.wi);
    p.pdf = drawn.pdf;
    p.weight = vec3(0.0f);
    if (drawn.pdf > 0.0f && dot(p.next_direction, at.ng) > 0.0f)
        p.weight = drawn.weight * at.channels;
    note_extended_scatter(p, drawn);
}

// The local frame, whose x is the direction of anisotropy, and the coat's normal in it.
HM_FN void extended_frame(HM_IN(HitIds) ids, HM_IN(Surface) s, HM_IN(ExtendedMaterialData) x,
                          HM_IN(ExtendedPoint) point, vec4 coat_texel, vec3 direction,
                          HM_OUT(Frame) frame, HM_OUT(vec3) coat_normal) {
    make_frame(s.ns, frame);
    coat_normal = vec3(0.0f, 0.0f, 1.0f);
    uint flags = geometries[s.geometry].flags;
    bool mapped = (flags & kGeometryNormalMapped) != 0u;
    bool coat_mapped = x.clearcoat_normal_texture != 0u;
    bool own_normal = point.clearcoat > 0.0f && (mapped || coat_mapped);
    bool tangents = (flags & kGeometryHasTangents) != 0u;
    if (!own_normal && !(point.anisotropy > 0.0f && tangents)) return;

    HM_ROW(InstanceData) instance = instances[ids.instance];
    Triangle t;
    load_triangle(s.geometry, ids.primitive, t);
    vec4 tangent = interpolated_tangent(t, s.weights);
    float side = s.front ? 1.0f : -1.0f;
    if (point.anisotropy > 0.0f && tangents) {
        float mirrored = (instance.flags & kInstanceFlipped) != 0u ? -side : side;
        vec3 u = transform_vector(instance.object_to_world, vec3(tangent.x, tangent.y, tangent.z));
        vec3 v = cross(s.ns, u) * (tangent.w * mirrored);
        vec3 along = u * point.anisotropy_direction.x + v * point.anisotropy_direction.y;
        along = along - s.ns * dot(s.ns, along);
        float size = dot(along, along);
        if (size > 1e-30f) {
            frame.s = along * inversesqrt(size);
            frame.t = cross(s.ns, frame.s);
        }
    }
    if (!own_normal) return;
    Surface bare = s;
    bare.ns = interpolated_normal(instance, flags, t, s.weights, s.ng * side);
    if (coat_mapped && tangents)
        bare.ns = map_normal(instance, bare, tangent, coat_texel, x.clearcoat_normal_scale);
    coat_normal = to_local(frame, repaired_normal(bare.ns * side, s.ng, -direction));
}

// Light that goes on beyond a dispersive boundary is of one channel from here on.
HM_FN void disperse(HM_INOUT(PathPayload) p, HM_IN(MaterialData) m, bool front, float number,
                    HM_INOUT(ExtendedBsdf) b, HM_INOUT(ExtendedShading) at) {
    uint channel = min(uint(number * 3.0f), 2u) + 1u;
    p.media = with_channel(p.media, channel);
    b.specular.eta = divide(medium_ior(top_medium(media_beyond(p.media, m, front)), channel),
                            medium_ior(medium_before(p.media, m, front), channel));
    at.channels =
        vec3(channel == 1u ? 3.0f : 0.0f, channel == 2u ? 3.0f : 0.0f, channel == 3u ? 3.0f : 0.0f);
}

HM_FN void extended_hit(HM_INOUT(PathPayload) p, HM_IN(HitIds) ids, HM_IN(Surface) s,
                        HM_IN(MaterialData) m, vec3 direction) {
    HM_ROW(ExtendedMaterialData) x = extended_materials[extended_row(m)];
    MaterialPoint base;
    load_material(m, s, base);
    ExtendedTexels texels;
    read_extended_texels(x, s.uv0, s.uv1, texels);
    ExtendedPoint point;
    load_extended(m, x, texels, base, point);
    ExtendedShading at;
    vec3 coat_normal;
    extended_frame(ids, s, x, point, texels.clearcoat_normal, direction, at.frame, coat_normal);
    at.wo = to_local(at.frame, -direction);
    at.channels = vec3(1.0f);

    bool solid = (m.flags & kMaterialVolume) != 0u;
    uint channel = path_channel(p.media);
    uint before = medium_before(p.media, m, s.front);
    uint beyond = top_medium(media_beyond(p.media, m, s.front));
    float eta = solid ? divide(medium_ior(beyond, channel), medium_ior(before, channel))
                      : medium_ior(extended_row(m) + 1u, 0u);
    ExtendedBsdf b;
    make_extended_bsdf(base, point, at.wo, coat_normal, eta, !solid, b);
    note_extended(p, base.base_color, base.metallic, b.roughness);

    SamplerState numbers;
    resume_sample(p, numbers);
    uint dimension = kDimensionBounce + 8u * p.bounce;
    uvec4 scatter_numbers = sample_4d(numbers, dimension);
    p.roulette = scatter_numbers.w;
    uvec4 light_numbers = sample_4d(numbers, dimension + 4u);

    float lobe = unit_float(scatter_numbers.x);
    at.far = lobe < b.transmits;
    if (at.far)
        lobe = min(divide(lobe, b.transmits), 0.99999994f);
    else
        lobe = min(divide(lobe - b.transmits, 1.0f - b.transmits), 0.99999994f);
    at.ng = s.ng;
    if (at.far) {
        at.ng = -s.ng;
        p.next_origin = s.position - s.ng * s.error;
        if (solid && channel == 0u && b.pane_probability > 0.0f && x.dispersion > 0.0f) {
            float place = lobe * 3.0f;
            disperse(p, m, s.front, lobe, b, at);
            lobe = place - floor(place);
        }
        p.media = media_beyond(p.media, m, s.front);
    }
    shade_extended_light(p, b, at, light_numbers);
    shade_extended_scatter(p, b, at, lobe, scatter_numbers);
}
