// The tables of shading/path and brute_force.h as storage buffers, in the order of
// PathTracer::buffers (path_tracer.h). Bindings 0 and 1 are the shader's own.
#include "gpu/world_triangle.h"
#include "shading/shading.h"

layout(scalar, binding = 2) readonly buffer Settings {
#define HM_FRAME_VALUE(Type, name) Type name;
#include "shading/tables.inl"
    uint world_triangle_count;
};
layout(scalar, binding = 3) readonly buffer SceneVertices { Vertex scene_vertices[]; };
layout(scalar, binding = 4) readonly buffer SceneExtras { VertexExtra scene_extras[]; };
layout(scalar, binding = 5) readonly buffer SceneTriangles { uvec3 scene_triangles[]; };
layout(scalar, binding = 6) readonly buffer SceneOffsets { uvec2 scene_offsets[]; };
layout(scalar, binding = 7) readonly buffer SceneImages { uvec3 scene_images[]; };
layout(scalar, binding = 8) readonly buffer SceneTexels { vec4 scene_texels[]; };
layout(scalar, binding = 9) readonly buffer WorldTriangles { WorldTriangle world_triangles[]; };

#define HM_TABLE(number, Type, name) \
    layout(scalar, binding = 10 + number) readonly buffer name##_table { Type name[]; };
#include "shading/tables.inl"

#include "gpu/brute_force.h"
