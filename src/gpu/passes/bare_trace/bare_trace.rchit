// Closest hit of the bare tracer: nothing. The payload says "hit" from the start.
#version 460
#extension GL_EXT_ray_tracing : require

layout(location = 0) rayPayloadInEXT uint hit;

void main() {}
