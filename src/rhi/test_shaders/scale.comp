// values[i] = values[i] * push.factor + texture's red at texel i of row 0, from the table's entry
// `push.slot`.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32) in;

layout(scalar, set = 0, binding = 0) buffer Values { uint values[]; };
layout(set = 1, binding = 0) uniform sampler2D textures[];
layout(push_constant) uniform Push {
    uint factor;
    uint slot;
    uint count;
} push;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= push.count) return;
    float red = texelFetch(textures[nonuniformEXT(push.slot)], ivec2(int(i), 0), 0).r;
    values[i] = values[i] * push.factor + uint(red * 255.0 + 0.5);
}
