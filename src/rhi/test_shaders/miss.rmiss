#version 460
#extension GL_EXT_ray_tracing : require

struct Radiance { uint key; uint seen; };
layout(location = 0) rayPayloadInEXT Radiance radiance;

void main() { radiance.seen = 1u; }
