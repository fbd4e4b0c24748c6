// The tables a GPU reads and the CPU shares: layout(scalar) in GLSL, plain structs in C++.
// Sizes and offsets are asserted below and read back from the SPIR-V by tests/gpu.
#ifndef HM_SHADING_STRUCTS_H
#define HM_SHADING_STRUCTS_H

#include "shading/lang.h"

#ifdef __cplusplus
#include <cstddef>
#endif

HM_NAMESPACE_BEGIN

HM_CONST uint kNone = 0xffffffffu;

HM_CONST uint kAlphaOpaque = 0u;
HM_CONST uint kAlphaMask = 1u;
HM_CONST uint kAlphaBlend = 2u;

HM_CONST uint kMaterialDoubleSided = 1u;
HM_CONST uint kMaterialUnlit = 2u;
// Its mesh bounds a volume (KHR_materials_volume with a thickness above 0).
HM_CONST uint kMaterialVolume = 4u;
// KHR_materials_pbrSpecularGlossiness: specular_color is the reflectance at normal incidence, and
// the alpha of its texture, times one minus the roughness factor, is the glossiness.
HM_CONST uint kMaterialGlossy = 8u;
// The flags' bits from this on are 1 + the material's row in `extended_materials`; 0: none.
HM_CONST uint kMaterialRowShift = 8u;

// A glTF metallic-roughness material. The texture fields index the table of texture uses and are
// never unset: a texture that the file does not give is a 1x1 default (see scene/flatten).
struct MaterialData {
    vec4 base_color_factor;
    vec3 emissive_factor;   // strength included, nits
    float specular_weight;  // scales the dielectric's F0 and F90; 0 is a pure Lambertian
    float metallic_factor;
    float roughness_factor;
    float normal_scale;
    float occlusion_strength;
    uint base_color_texture;
    uint emissive_texture;
    uint metallic_roughness_texture;
    uint normal_texture;
    uint occlusion_texture;
    float alpha_cutoff;
    uint alpha_mode;
    uint flags;  // kMaterial*
};

// What extensions add to a material: the HM_EXTENDED_ entries of material/parameters.inl, textures
// as indices into the table of texture uses. Only materials that use one have a row.
struct ExtendedMaterialData {
#define HM_EXTENDED_FACTOR(owner, key, type, member, start, low, high, below, animated, meaning) \
    type member;
#define HM_EXTENDED_TEXTURE(owner, key, slot, read, encoding, meaning) uint slot;
#include "shading/material/parameters.inl"
};

// Rows of materials with a volume come first: path/media.h numbers them by ten bits, 0 is none.
HM_CONST uint kMaxVolumes = 1023u;

HM_CONST uint kWrapRepeat = 0u;
HM_CONST uint kWrapClamp = 1u;
HM_CONST uint kWrapMirror = 2u;
HM_CONST uint kFilterLinear = 0u;
HM_CONST uint kFilterNearest = 1u;

// How a material slot reads an image: uv' = (dot(uv_row_u, (uv, 1)), dot(uv_row_v, (uv, 1))).
struct TextureUse {
    uint image;
    uint wrap_u;
    uint wrap_v;
    uint filter_mode;
    uint uv_set;
    vec3 uv_row_u;
    vec3 uv_row_v;
};

// How the colour channels of texels are encoded. The texture slot decides it, so it is a
// compile-time constant at each lookup, and the other decoding is optimised away.
HM_CONST uint kEncodingLinear = 0u;
HM_CONST uint kEncodingSrgb = 1u;

// Attributes that every mesh has, 48 bytes; tangent.w is the sign of the bitangent. uv1 and colours
// are in VertexExtra.
struct Vertex {
    vec3 position;
    vec3 normal;
    vec4 tangent;
    vec2 uv0;
};

struct VertexExtra {
    vec2 uv1;
    vec4 color;
};

HM_CONST uint kGeometryHasNormals = 1u;
HM_CONST uint kGeometryHasExtras = 2u;
HM_CONST uint kGeometryNormalMapped = 4u;  // its vertices have tangents
HM_CONST uint kGeometryHasTangents = 8u;

// One primitive of one mesh. Its vertices are reached by the hook load_triangle.
struct GeometryData {
    uint material;
    uint flags;           // kGeometry*
    uint emitter_offset;  // of its triangle 0, from the instance's first emitter; kNone if it emits
                          // nothing
    uint triangle_count;
};

HM_CONST uint kInstanceFlipped = 1u;  // the transform mirrors and so reverses the winding

struct InstanceData {
    mat4x3 object_to_world;
    mat4x3 world_to_object;
    uint first_geometry;  // geometries of its mesh follow each other
    uint first_emitter;
    uint flags;  // kInstance*
    uint mesh;
};

HM_CONST uint kLightDirectional = 0u;
HM_CONST uint kLightPoint = 1u;
HM_CONST uint kLightSpot = 2u;

// KHR_lights_punctual, world space. color includes intensity: lux for directional, candela else.
struct LightData {
    vec3 position;
    vec3 direction;  // in which the light travels
    vec3 color;
    float range;  // metres; 0: no limit
    float spot_scale;
    float spot_offset;
    uint kind;  // kLight*
    // Of the surface that a point or spot light lies on (scene/light_surfaces.h). The normal is
    // zero if there are several surfaces.
    vec3 surface_normal;
    float surface_error;  // hit_error; 0: on no surface
};

// Walker's alias method over integers: slot = mul_high(random, n); the slot itself is taken if
// coin < threshold, else `alias`. pdf_* are the discrete probabilities of either outcome.
struct AliasEntry {
    uint threshold;
    uint alias;
    float pdf_self;
    float pdf_alias;
};

// A triangle that emits, in world space.
struct EmitterTriangle {
    vec3 p0;
    vec3 p1;
    vec3 p2;
    uint instance;
    uint geometry;  // within the instance's mesh
    uint primitive;
    float error;  // of its points along the normal: hit_error at the farthest corner
};

HM_CONST uint kCameraPerspective = 0u;
HM_CONST uint kCameraOrthographic = 1u;

struct CameraData {
    vec3 origin;
    vec3 right;        // unit
    vec3 up;           // unit
    vec3 forward;      // unit, into the picture
    float half_width;  // of the image plane at distance 1 (perspective) or in metres (orthographic)
    float half_height;
    float lens_radius;     // metres; 0: pinhole
    float focus_distance;  // metres along the axis
    uint kind;             // kCamera*
};

struct EnvironmentData {
    uint width;
    uint height;
    float u_offset;   // --env-rotation / 360
    float intensity;  // 0: no environment
};

HM_CONST uint kSamplerIndependent = 0u;
HM_CONST uint kSamplerSobolBlueNoise = 1u;
HM_CONST uint kSamplerSobolOwen = 2u;

HM_CONST uint kStrategyMis = 0u;
HM_CONST uint kStrategyLight = 1u;
HM_CONST uint kStrategyBsdf = 2u;

// The albedo table: rows over roughness, columns over the square root of the cosine.
HM_CONST uint kAlbedoRows = 48u;
HM_CONST uint kAlbedoColumns = 32u;

// The tables of extended materials (material/energy.h).
HM_CONST uint kSheenRows = 64u;
HM_CONST uint kSheenColumns = 64u;
HM_CONST uint kGlassIndices = 16u;
HM_CONST uint kGlassRows = 20u;
HM_CONST uint kGlassColumns = 28u;
HM_CONST uint kAnisotropyStrengths = 8u;
HM_CONST uint kAnisotropyRows = 12u;
HM_CONST uint kAnisotropyAzimuths = 5u;
HM_CONST uint kAnisotropyColumns = 20u;

HM_CONST uint kDiffuseLambert = 0u;
HM_CONST uint kDiffuseBurley = 1u;

HM_CONST uint kBackgroundEnvironment = 0u;
HM_CONST uint kBackgroundColor = 1u;
HM_CONST uint kBackgroundTransparent = 2u;

// One kind of light among the three: it is picked when a 32-bit number falls into [begin, end), and
// the number is stretched back over 32 bits by (x - begin) * (scale_int + scale_frac / 2^32).
struct LightRange {
    uint begin;
    uint end;
    uint scale_int;
    uint scale_frac;
    float pdf;  // the probability of this kind; 0: never picked
};

struct RenderParams {
    uint width;  // of the whole picture, independent of the crop
    uint height;
    uint seed;
    uint sampler_kind;   // kSampler*
    uint max_bounces;    // scattering events; 0: no limit
    float max_radiance;  // --clamp; 0: off
    uint strategy;       // kStrategy*
    uint energy_compensation;
    uint diffuse_kind;  // kDiffuse*
    uint background;    // kBackground*
    vec3 background_color;
    float filter_width;  // pixels; the inverse CDF table spans -1..1 times half of it
    LightRange environment_range;
    LightRange punctual_range;
    LightRange emitter_range;
    uint light_count;
    uint emitter_count;
};

// Parameters of the stages' AOV variants (HM_AOVS), in addition to RenderParams.
struct AovParams {
    uint light_groups;       // how many
    uint replicates;         // of the samples, each randomised on its own; 0 or 1: none
    uint moves;              // 1: there are tables of the next frame
    CameraData next_camera;  // at the next frame
};

HM_NAMESPACE_END

#ifdef __cplusplus
namespace hm {
static_assert(sizeof(MaterialData) == 80 && offsetof(MaterialData, specular_weight) == 28 &&
              offsetof(MaterialData, base_color_texture) == 48 &&
              offsetof(MaterialData, flags) == 76);
static_assert(sizeof(TextureUse) == 44 && offsetof(TextureUse, uv_row_u) == 20);
static_assert(sizeof(Vertex) == 48 && sizeof(VertexExtra) == 24);
static_assert(sizeof(GeometryData) == 16 && sizeof(InstanceData) == 112);
static_assert(sizeof(LightData) == 68 && sizeof(AliasEntry) == 16);
static_assert(sizeof(EmitterTriangle) == 52 && sizeof(CameraData) == 68);
static_assert(sizeof(AovParams) == 80);
}  // namespace hm
#endif

#endif
