// A buffer of every struct of shading/structs.h, for layout_test to read the offsets from. Each row is
// copied once, so that the compiler keeps its type.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 1) in;

#include "shading/structs.h"

layout(scalar, binding = 0) buffer MaterialDataTable { MaterialData rows[]; } material_data;
layout(scalar, binding = 1) buffer TextureUseTable { TextureUse rows[]; } texture_use;
layout(scalar, binding = 2) buffer VertexTable { Vertex rows[]; } vertex;
layout(scalar, binding = 3) buffer VertexExtraTable { VertexExtra rows[]; } vertex_extra;
layout(scalar, binding = 4) buffer GeometryDataTable { GeometryData rows[]; } geometry_data;
layout(scalar, binding = 5) buffer InstanceDataTable { InstanceData rows[]; } instance_data;
layout(scalar, binding = 6) buffer LightDataTable { LightData rows[]; } light_data;
layout(scalar, binding = 7) buffer AliasEntryTable { AliasEntry rows[]; } alias_entry;
layout(scalar, binding = 8) buffer EmitterTriangleTable { EmitterTriangle rows[]; } emitter_triangle;
layout(scalar, binding = 9) buffer CameraDataTable { CameraData rows[]; } camera_data;
layout(scalar, binding = 10) buffer EnvironmentDataTable { EnvironmentData rows[]; } environment_data;
layout(scalar, binding = 11) buffer LightRangeTable { LightRange rows[]; } light_range;
layout(scalar, binding = 12) buffer RenderParamsTable { RenderParams rows[]; } render_params;
layout(scalar, binding = 13) buffer AovParamsTable { AovParams rows[]; } aov_params;

void main() {
    material_data.rows[1] = material_data.rows[0];
    texture_use.rows[1] = texture_use.rows[0];
    vertex.rows[1] = vertex.rows[0];
    vertex_extra.rows[1] = vertex_extra.rows[0];
    geometry_data.rows[1] = geometry_data.rows[0];
    instance_data.rows[1] = instance_data.rows[0];
    light_data.rows[1] = light_data.rows[0];
    alias_entry.rows[1] = alias_entry.rows[0];
    emitter_triangle.rows[1] = emitter_triangle.rows[0];
    camera_data.rows[1] = camera_data.rows[0];
    environment_data.rows[1] = environment_data.rows[0];
    light_range.rows[1] = light_range.rows[0];
    render_params.rows[1] = render_params.rows[0];
    aov_params.rows[1] = aov_params.rows[0];
}
