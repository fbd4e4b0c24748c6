// The scene as shaders see it: sets 0 and 1 under the names that shading/path uses, and the hooks
// that read them. gpu/scene.cpp fills set 0, gpu/textures.cpp set 1.
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_ray_tracing : require

#include "gpu/tables.h"
#include "shading/shading.h"

// Stages read the settings from a copy, `params`, which load_params makes.
#define params frame_params
#define HM_FRAME_VALUE(Type, name) Type name;
layout(scalar, set = 0, binding = kFrameBinding) uniform FrameValues {
#include "shading/tables.inl"
};
#undef params
layout(set = 0, binding = kStructureBinding) uniform accelerationStructureEXT scene_structure;
layout(scalar, set = 0, binding = kGeometryAddressesBinding) readonly buffer GeometryArrays {
    GeometryAddresses geometry_addresses[];
};

#define HM_TABLE(number, Type, name)                                    \
    layout(scalar, set = 0, binding = kFirstTableBinding + number) \
        readonly buffer name##_table { Type name[]; };
#include "shading/tables.inl"

// The bits of a setting, or this where the pipeline leaves it to the frame's values.
const uint kFromFrame = 0xffffffffu;
#define HM_SETTING(id, name) layout(constant_id = id) const uint fixed_##name = kFromFrame;
#define HM_SETTING_OR_ZERO(id, name) HM_SETTING(id, name)
#include "gpu/passes/path_tracing/settings.inl"

uint fixed_or(uint bits, uint value) {
    return bits == kFromFrame ? value : bits;
}
float fixed_or(uint bits, float value) {
    return bits == kFromFrame ? value : uintBitsToFloat(bits);
}

RenderParams params;

// Must be called first in every stage.
void load_params() {
    params = frame_params;
#define HM_SETTING(id, name) params.name = fixed_or(fixed_##name, frame_params.name);
#define HM_SETTING_OR_ZERO(id, name) HM_SETTING(id, name)
#include "gpu/passes/path_tracing/settings.inl"
}

layout(set = 1, binding = 0) uniform sampler2D scene_images[];

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

// Devices round differently when they convert texels to floats. Rounded back to 16 bits, a texel of
// either depth has the value of scene/image_view.h; colours, which decide no branch of a path, stay
// as they are.
vec4 fetch_texel(uint image, uint x, uint y, uint encoding) {
    HM_MAY_CONTRACT
    vec4 texel = texelFetch(scene_images[nonuniformEXT(image)], ivec2(x, y), 0);
    if (encoding == kEncodingLinear) return floor(texel * 65535.0f + 0.5f) * (1.0f / 65535.0f);
    return vec4(srgb_to_linear(texel.x), srgb_to_linear(texel.y), srgb_to_linear(texel.z), texel.w);
}
