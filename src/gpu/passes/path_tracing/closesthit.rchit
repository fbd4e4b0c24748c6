// Closest hit: facts about the surface, for ray generation to combine.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "gpu/bindings.glsl"

#include "gpu/passes/path_tracing/aovs.glsl"

layout(location = 0) rayPayloadInEXT PathPayload path_payload;

#include "shading/path/sampler.h"
#include "shading/texture/lookup.h"
#include "shading/material/textures.h"
#include "shading/path/surface.h"
#include "shading/material/material.h"
#include "shading/material/bsdf.h"
#include "shading/material/extended_lobes.h"
#include "shading/light/light.h"
#include "shading/path/closest_hit.h"

void main() {
    load_params();
    HitIds ids;
    ids.instance = gl_InstanceCustomIndexEXT;
    ids.geometry = gl_GeometryIndexEXT;
    ids.primitive = gl_PrimitiveID;
    closest_hit(path_payload, ids, gl_WorldRayOriginEXT, gl_WorldRayDirectionEXT);
}
