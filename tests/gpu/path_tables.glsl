// The tables of shading/path and brute_force.h as storage buffers; PathTracer::buffers (path_tracer.h)
// lists them in this order. Bindings 0 and 1 are the shader's own.
#include "gpu/world_triangle.h"
#include "shading/shading.h"

layout(scalar, binding = 2) readonly buffer Settings {
    RenderParams params;
    CameraData camera;
    EnvironmentData environment;
    uint world_triangle_count;
};
layout(scalar, binding = 3) readonly buffer SobolDirections { uint sobol_directions[]; };
layout(scalar, binding = 4) readonly buffer SobolNibbles { uvec4 sobol_nibbles[]; };
layout(scalar, binding = 5) readonly buffer BlueNoise { uint blue_noise[]; };
layout(scalar, binding = 6) readonly buffer AlbedoTable { vec2 albedo_table[]; };
layout(scalar, binding = 7) readonly buffer AlbedoAverage { vec2 albedo_average[]; };
layout(scalar, binding = 8) readonly buffer FilterTable { float filter_table[]; };
layout(scalar, binding = 9) readonly buffer Materials { MaterialData materials[]; };
layout(scalar, binding = 10) readonly buffer TextureUses { TextureUse texture_uses[]; };
layout(scalar, binding = 11) readonly buffer Geometries { GeometryData geometries[]; };
layout(scalar, binding = 12) readonly buffer Instances { InstanceData instances[]; };
layout(scalar, binding = 13) readonly buffer Lights { LightData lights[]; };
layout(scalar, binding = 14) readonly buffer LightAlias { AliasEntry light_alias[]; };
layout(scalar, binding = 15) readonly buffer Emitters { EmitterTriangle emitters[]; };
layout(scalar, binding = 16) readonly buffer EmitterAlias { AliasEntry emitter_alias[]; };
layout(scalar, binding = 17) readonly buffer EnvironmentTexels { vec4 environment_texels[]; };
layout(scalar, binding = 18) readonly buffer EnvironmentAlias { AliasEntry environment_alias[]; };
layout(scalar, binding = 19) readonly buffer SceneVertices { Vertex scene_vertices[]; };
layout(scalar, binding = 20) readonly buffer SceneExtras { VertexExtra scene_extras[]; };
layout(scalar, binding = 21) readonly buffer SceneTriangles { uvec3 scene_triangles[]; };
layout(scalar, binding = 22) readonly buffer SceneOffsets { uvec2 scene_offsets[]; };
layout(scalar, binding = 23) readonly buffer SceneImages { uvec3 scene_images[]; };
layout(scalar, binding = 24) readonly buffer SceneTexels { vec4 scene_texels[]; };
layout(scalar, binding = 25) readonly buffer WorldTriangles { WorldTriangle world_triangles[]; };

#include "gpu/brute_force.h"
