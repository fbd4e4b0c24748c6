#version 460
#extension GL_EXT_ray_tracing : require

struct Shadow { uint key; uint visible; };
layout(location = 1) rayPayloadInEXT Shadow shadow;

void main() { shadow.visible = 1u; }
