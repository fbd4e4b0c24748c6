// AOVs: the further outputs of a sample. steps.h includes this with HM_AOVS, and without it
// aovs_off.h, which costs nothing.
//
// Direct light has scattered once, indirect light more often; both are split by the diffuse lobe's
// share of f at the first hit, per channel. So emission and the four passes sum to the radiance, as
// do the light groups.
//
// Hooks, on the planes of aov_planes.h at the sample's own pixel: has_plane: whether the film
// has one; plane_value reads and set_plane_value writes float `at` of `floats`. keep_ids gets
// what the sample hit, for cryptomattes. moved_position is the position of a point of a triangle in
// the next frame, in world space.
// Tables: aovs (AovParams); source_groups, of each source of light (kSourceEnvironment).

HM_HOOK(bool has_plane(uint plane))
HM_HOOK(float plane_value(uint plane, uint floats, uint at))
HM_HOOK(void set_plane_value(uint plane, uint floats, uint at, float value))
HM_HOOK(void keep_ids(uint index, HM_IN(HitIds) ids))
HM_HOOK(vec3 moved_position(HM_IN(HitFacts) facts))

HM_FN void add_to_plane(uint plane, uint floats, uint at, float value) {
    set_plane_value(plane, floats, at, plane_value(plane, floats, at) + value);
}

HM_FN void add_plane_1(uint plane, float value) {
    if (has_plane(plane)) add_to_plane(plane, 1u, 0u, value);
}

HM_FN void add_plane_3(uint plane, vec3 value) {
    if (!has_plane(plane)) return;
    add_to_plane(plane, 3u, 0u, value.x);
    add_to_plane(plane, 3u, 1u, value.y);
    add_to_plane(plane, 3u, 2u, value.z);
}

// Whether this sample's value replaces the one in a plane that keeps the lowest sample index.
HM_FN bool claims_plane(uint plane, uint floats, uint index) {
    if (!has_plane(plane)) return false;
    float holder = plane_value(plane, floats, floats - 1u);
    if (holder > 0.0f && holder <= float(index + 1u)) return false;
    set_plane_value(plane, floats, floats - 1u, float(index + 1u));
    return true;
}

HM_FN void begin_aovs(HM_INOUT(PathSample) s) {
    s.emission = vec3(0.0f);
    s.diffuse_direct = vec3(0.0f);
    s.specular_direct = vec3(0.0f);
    s.diffuse_indirect = vec3(0.0f);
    s.specular_indirect = vec3(0.0f);
    s.first_diffuse_share = vec3(0.0f);
    s.hit = false;
}

// A contribution with a NaN or an infinity is skipped: its sample counts as black.
HM_FN void add_to_group(uint source, vec3 kept) {
    if (!has_plane(kPlaneLightGroups) || !is_finite_color(kept)) return;
    uint floats = 3u * aovs.light_groups;
    uint at = 3u * source_groups[source];
    add_to_plane(kPlaneLightGroups, floats, at, kept.x);
    add_to_plane(kPlaneLightGroups, floats, at + 1u, kept.y);
    add_to_plane(kPlaneLightGroups, floats, at + 2u, kept.z);
}

HM_FN void split_light(HM_INOUT(PathSample) s, vec3 kept, vec3 share, bool direct) {
    vec3 diffuse = kept * share;
    vec3 specular = kept - diffuse;
    if (direct) {
        s.diffuse_direct = s.diffuse_direct + diffuse;
        s.specular_direct = s.specular_direct + specular;
    } else {
        s.diffuse_indirect = s.diffuse_indirect + diffuse;
        s.specular_indirect = s.specular_indirect + specular;
    }
}

// The emission of what a ray hit; `kept` is the part that was added to the radiance.
HM_FN void note_emitted(HM_INOUT(PathSample) s, HM_IN(PathPayload) p, vec3 kept) {
    if (p.bounce == 0u) {
        s.emission = s.emission + kept;
        s.hit = p.hit_distance >= 0.0f;
        if (s.hit) s.facts = p.facts;
    } else {
        split_light(s, kept, s.first_diffuse_share, p.bounce == 1u);
    }
    if (max_component(kept) > 0.0f) add_to_group(p.emitted_source, kept);
}

// An unoccluded light sample.
HM_FN void note_lit(HM_INOUT(PathSample) s, HM_IN(PathPayload) p, vec3 kept) {
    if (p.bounce == 0u)
        split_light(s, kept, p.light_diffuse_share, true);
    else
        split_light(s, kept, s.first_diffuse_share, false);
    add_to_group(p.light_source, kept);
}

HM_FN void note_first_scatter(HM_INOUT(PathSample) s, HM_IN(PathPayload) p) {
    if (p.bounce == 0u) s.first_diffuse_share = p.diffuse_share;
}

// Motion in pixels to the next frame, x to the right and y upwards; zero for points that move
// behind the camera.
HM_FN vec2 motion_of(HM_IN(HitFacts) facts) {
    vec2 now;
    vec2 next;
    if (aovs.moves == 0u) return vec2(0.0f);
    if (!project_point(camera, facts.position, now)) return vec2(0.0f);
    if (!project_point(aovs.next_camera, moved_position(facts), next)) return vec2(0.0f);
    return vec2((next.x - now.x) * float(params.width), (now.y - next.y) * float(params.height));
}

HM_FN void add_hit(uint index, HM_IN(HitFacts) facts) {
    keep_ids(index, facts.ids);
    add_plane_3(kPlaneAlbedo, facts.albedo);
    add_plane_1(kPlaneMetallic, facts.metallic);
    add_plane_1(kPlaneRoughness, facts.roughness);
    add_plane_3(kPlaneNormal, facts.ns);
    add_plane_3(kPlaneGeometricNormal, facts.ng);
    if (has_plane(kPlaneDepth)) {
        add_to_plane(kPlaneDepth, 2u, 0u, dot(facts.position - camera.origin, camera.forward));
        add_to_plane(kPlaneDepth, 2u, 1u, 1.0f);
    }
    if (has_plane(kPlanePosition)) {
        add_to_plane(kPlanePosition, 4u, 0u, facts.position.x);
        add_to_plane(kPlanePosition, 4u, 1u, facts.position.y);
        add_to_plane(kPlanePosition, 4u, 2u, facts.position.z);
        add_to_plane(kPlanePosition, 4u, 3u, 1.0f);
    }
    if (claims_plane(kPlaneUv, 3u, index)) {
        set_plane_value(kPlaneUv, 3u, 0u, facts.uv.x);
        set_plane_value(kPlaneUv, 3u, 1u, facts.uv.y);
    }
    if (claims_plane(kPlaneMotion, 3u, index)) {
        vec2 motion = motion_of(facts);
        set_plane_value(kPlaneMotion, 3u, 0u, motion.x);
        set_plane_value(kPlaneMotion, 3u, 1u, motion.y);
    }
    if (claims_plane(kPlaneMaterialId, 2u, index))
        set_plane_value(kPlaneMaterialId, 2u, 0u, float(facts.material + 1u));
    if (claims_plane(kPlaneInstanceId, 2u, index))
        set_plane_value(kPlaneInstanceId, 2u, 0u, float(facts.ids.instance + 1u));
}

// After add_sample took the sample, in the order of the indices.
HM_FN void add_aovs(uint index, HM_IN(PathSample) s) {
    add_plane_3(kPlaneEmission, s.emission);
    add_plane_3(kPlaneDiffuseDirect, s.diffuse_direct);
    add_plane_3(kPlaneSpecularDirect, s.specular_direct);
    add_plane_3(kPlaneDiffuseIndirect, s.diffuse_indirect);
    add_plane_3(kPlaneSpecularIndirect, s.specular_indirect);
    add_plane_3(kPlaneSquares, s.radiance * s.radiance);
    if (has_plane(kPlaneReplicates)) {
        uint floats = 4u * kReplicates;
        uint at = 4u * (index % kReplicates);
        add_to_plane(kPlaneReplicates, floats, at, s.radiance.x);
        add_to_plane(kPlaneReplicates, floats, at + 1u, s.radiance.y);
        add_to_plane(kPlaneReplicates, floats, at + 2u, s.radiance.z);
        add_to_plane(kPlaneReplicates, floats, at + 3u, 1.0f);
    }
    if (s.hit) add_hit(index, s.facts);
}
