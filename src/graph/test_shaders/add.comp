// sums = push.factor * sums + source, texel by texel; the source is sampled.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, r32f) uniform image2D sums;
layout(set = 0, binding = 1) uniform sampler2D source;
layout(push_constant) uniform Push { float factor; } push;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(sums)))) return;
    float old = imageLoad(sums, p).r;
    imageStore(sums, p, vec4(push.factor * old + texelFetch(source, p, 0).r));
}
