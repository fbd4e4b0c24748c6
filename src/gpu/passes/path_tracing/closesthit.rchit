// Closest hit: facts about the surface, for ray generation to combine.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "gpu/bindings.glsl"

#include "gpu/passes/path_tracing/aovs.glsl"

layout(location = 0) rayPayloadInEXT PathPayload path_payload;

#include "shading/path/sampler.h"
#include "shading/path/texture.h"
#include "shading/path/surface.h"
#include "shading/path/bsdf.h"
#include "shading/path/environment.h"
#include "shading/path/emission.h"
#include "shading/path/light_sampling.h"
#ifdef HM_SHADOW_FROM_HIT
#include "gpu/passes/path_tracing/shadow_ray.glsl"

vec3 light_direction;
float light_t_max;

void keep_light_ray(vec3 direction, float t_max) {
    light_direction = direction;
    light_t_max = t_max;
}

// After all else, so that nothing but the payload outlives the ray.
void test_light() {
    path_payload.shadow_rays = 0u;
    if (!(max_component(path_payload.light_contribution) > 0.0f)) return;
    path_payload.shadow_rays = 1u;
    if (!trace_shadow_ray(path_payload.next_origin, light_direction, light_t_max,
                          shadow_key(path_payload.key)))
        path_payload.light_contribution = vec3(0.0f);
}
#else
void test_light() {}
#endif

#include "shading/path/closest_hit.h"

void main() {
    load_params();
    HitIds ids;
    ids.instance = gl_InstanceCustomIndexEXT;
    ids.geometry = gl_GeometryIndexEXT;
    ids.primitive = gl_PrimitiveID;
    closest_hit(path_payload, ids, gl_WorldRayOriginEXT, gl_WorldRayDirectionEXT);
    test_light();
}
