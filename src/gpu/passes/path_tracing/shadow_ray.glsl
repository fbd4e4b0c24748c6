// The shadow ray, for the stage that traces it: ray generation, or closest hit in the build
// HM_SHADOW_FROM_HIT.
layout(location = 1) rayPayloadEXT ShadowPayload shadow_payload;

// The shader binding table's order of groups.
const uint kAllMasks = 0xffu;
const uint kPathGroup = 0u;
const uint kShadowGroup = 1u;

bool trace_shadow_ray(vec3 origin, vec3 direction, float t_max, uint key) {
    shadow_payload.key = key;
    shadow_payload.visible = 0u;
    traceRayEXT(scene_structure,
                gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsSkipClosestHitShaderEXT, kAllMasks,
                kShadowGroup, 0u, kShadowGroup, origin, 0.0f, direction, t_max, 1);
    return shadow_payload.visible != 0u;
}
