// Miss of a path's ray: the environment.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "gpu/bindings.glsl"

#include "gpu/passes/path_tracing/aovs.glsl"

layout(location = 0) rayPayloadInEXT PathPayload path_payload;

#include "shading/texture/lookup.h"
#include "shading/material/textures.h"
#include "shading/path/surface.h"
#include "shading/material/material.h"
#include "shading/material/bsdf.h"
#include "shading/material/extended_lobes.h"
#include "shading/light/light.h"
#include "shading/path/miss.h"

void main() {
    load_params();
    miss(path_payload, gl_WorldRayDirectionEXT);
}
