// 1000 + 100 * the instance's custom index + 10 * geometry + primitive.
#version 460
#extension GL_EXT_ray_tracing : require

struct Radiance { uint key; uint seen; };
layout(location = 0) rayPayloadInEXT Radiance radiance;

void main() {
    radiance.seen = 1000u + 100u * uint(gl_InstanceCustomIndexEXT) +
                    10u * uint(gl_GeometryIndexEXT) + uint(gl_PrimitiveID);
}
