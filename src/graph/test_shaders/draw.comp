// target = push.value everywhere.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, r32f) uniform writeonly image2D target;
layout(push_constant) uniform Push { float value; } push;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(p, imageSize(target)))) imageStore(target, p, vec4(push.value));
}
