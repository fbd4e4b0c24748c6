// A picture by the whole path tracer: one invocation per pixel, its samples in index order.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

#include "gpu/path_tables.glsl"

layout(scalar, binding = 0) writeonly buffer Picture { vec4 picture[]; };
layout(scalar, binding = 1) readonly buffer Run { uint sample_count; };

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= params.width * params.height) return;
    vec4 sum = vec4(0.0f);
    for (uint i = 0u; i < sample_count; ++i) {
        PathSample s;
        trace_sample(pixel % params.width, pixel / params.width, i, s);
        sum += vec4(s.radiance, s.alpha);
    }
    picture[pixel] = sum / float(sample_count);
}
