// The scene as shaders see it: sets 0 and 1 under the names that shading/path uses, and its hooks
// that read them. gpu/scene_set.cpp makes the sets.
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_ray_tracing : require

#include "gpu/tables.h"
#include "shading/shading.h"

layout(scalar, set = 0, binding = 0) uniform Frame_ {
    RenderParams frame_params;
    CameraData camera;
    EnvironmentData environment;
};

RenderParams params;

// The first thing that every stage does. In the build HM_USUAL the settings that nearly all pictures
// have are constants, and what serves others falls away: about a tenth faster on an H100.
// gpu/renderer.cpp chooses it (is_usual).
void load_params() {
    params = frame_params;
#ifdef HM_USUAL
    params.sampler_kind = kSamplerSobolOwen;
    params.max_radiance = 0.0f;
    params.strategy = kStrategyMis;
    params.energy_compensation = 1u;
    params.diffuse_kind = kDiffuseLambert;
    params.background = kBackgroundEnvironment;
#endif
}
layout(scalar, set = 0, binding = 1) readonly buffer Lights { LightData lights[]; };
layout(scalar, set = 0, binding = 2) readonly buffer Materials { MaterialData materials[]; };
layout(scalar, set = 0, binding = 3) readonly buffer Instances { InstanceData instances[]; };
layout(set = 0, binding = 4) uniform accelerationStructureEXT scene_structure;
layout(scalar, set = 0, binding = 5) readonly buffer GeometryArrays {
    GeometryAddresses geometry_addresses[];
};
layout(scalar, set = 0, binding = 6) readonly buffer Geometries { GeometryData geometries[]; };
layout(scalar, set = 0, binding = 7) readonly buffer TextureUses { TextureUse texture_uses[]; };
layout(scalar, set = 0, binding = 8) readonly buffer LightAlias { AliasEntry light_alias[]; };
layout(scalar, set = 0, binding = 9) readonly buffer Emitters { EmitterTriangle emitters[]; };
layout(scalar, set = 0, binding = 10) readonly buffer EmitterAlias { AliasEntry emitter_alias[]; };
layout(scalar, set = 0, binding = 11) readonly buffer EnvironmentTexels {
    vec4 environment_texels[];
};
layout(scalar, set = 0, binding = 12) readonly buffer EnvironmentAlias {
    AliasEntry environment_alias[];
};
layout(scalar, set = 0, binding = 13) readonly buffer SobolNibbles { uvec4 sobol_nibbles[]; };
layout(scalar, set = 0, binding = 14) readonly buffer BlueNoise { uint blue_noise[]; };
layout(scalar, set = 0, binding = 15) readonly buffer AlbedoTable { vec2 albedo_table[]; };
layout(scalar, set = 0, binding = 16) readonly buffer AlbedoAverage { vec2 albedo_average[]; };
layout(scalar, set = 0, binding = 17) readonly buffer FilterTable { float filter_table[]; };

layout(set = 1, binding = 0) uniform sampler2D scene_images[];

layout(set = 3, binding = 3, scalar) readonly buffer SobolDirections { uint sobol_directions[]; };

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer VertexArray {
    Vertex at[];
};
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer VertexExtraArray {
    VertexExtra at[];
};
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer TriangleArray {
    uvec3 at[];
};

void load_triangle(uint geometry, uint primitive, out Triangle triangle) {
    GeometryAddresses arrays = geometry_addresses[geometry];
    uvec3 corners = TriangleArray(arrays.triangles).at[primitive];
    VertexArray vertices = VertexArray(arrays.vertices);
    triangle.a = vertices.at[corners.x];
    triangle.b = vertices.at[corners.y];
    triangle.c = vertices.at[corners.z];
}

void load_triangle_extras(uint geometry, uint primitive, out TriangleExtras extras) {
    GeometryAddresses arrays = geometry_addresses[geometry];
    uvec3 corners = TriangleArray(arrays.triangles).at[primitive];
    VertexExtraArray vertices = VertexExtraArray(arrays.extras);
    extras.a = vertices.at[corners.x];
    extras.b = vertices.at[corners.y];
    extras.c = vertices.at[corners.z];
}

uvec2 image_size(uint image) {
    return uvec2(textureSize(scene_images[nonuniformEXT(image)], 0));
}

// Devices turn integers into floats in ways of their own. Taken back to 16 bits, a texel of either
// depth has the value of scene/image_view.h; colours, which turn no path, are left as they come.
vec4 fetch_texel(uint image, uint x, uint y, uint encoding) {
    HM_MAY_CONTRACT
    vec4 texel = texelFetch(scene_images[nonuniformEXT(image)], ivec2(x, y), 0);
    if (encoding == kEncodingLinear) return floor(texel * 65535.0f + 0.5f) * (1.0f / 65535.0f);
    return vec4(srgb_to_linear(texel.x), srgb_to_linear(texel.y), srgb_to_linear(texel.z), texel.w);
}
