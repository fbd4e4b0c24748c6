// The data that the stages of the path tracer exchange.
#ifndef HM_SHADING_PATH_TYPES_H
#define HM_SHADING_PATH_TYPES_H

#include "shading/structs.h"

HM_NAMESPACE_BEGIN

// Sources of light, numbered: the environment (and any other background), then punctual light i as
// 1 + i, then emissive material m as 1 + params.light_count + m.
HM_CONST uint kSourceEnvironment = 0u;

struct HitIds {
    uint instance;
    uint geometry;  // within the instance's mesh
    uint primitive;
};

struct Triangle {
    Vertex a;
    Vertex b;
    Vertex c;
};

struct TriangleExtras {
    VertexExtra a;
    VertexExtra b;
    VertexExtra c;
};

#ifdef HM_AOVS
// What AOVs need to know of the surface that a camera ray hit.
struct HitFacts {
    HitIds ids;
    uint material;
    uint geometry;  // into `geometries`
    vec3 weights;   // of the triangle's corners
    vec2 uv;
    vec3 position;  // world space, as the normals
    vec3 ns;
    vec3 ng;
    vec3 albedo;
    float metallic;
    float roughness;
};
#endif

// Ray generation writes the first block, closest hit or miss the rest and, where the path enters or
// leaves one, the media. Both payloads begin with `key` and `index`, which any-hit reads.
struct PathPayload {
    uint key;     // of this ray's stochastic alpha
    uint index;   // of the sample; with AOVs, within its replicate's sequence
    uint pixel;   // x | y << 16
    uint bounce;  // scattering events before this ray; 0: a camera ray
    uint media;   // that the ray is in (path/media.h)
#ifdef HM_AOVS
    uint replicate;
#endif

    float hit_distance;   // < 0: a miss
    uint passed_through;  // 1: a camera ray hit a single-sided back face; continue at next_origin
    vec3 emitted;         // radiance towards the ray's origin
    float emitted_pdf;    // solid-angle pdf with which light sampling would sample this; 0: never
    vec3 next_origin;
    vec3 next_direction;
    vec3 weight;           // f cos / pdf; 0 ends the path
    float pdf;             // of next_direction, whole mixture of lobes
    uint roulette;         // this bounce's number for Russian roulette
    vec3 light_direction;  // one light sample, not yet tested for visibility
    float light_distance;
    vec3 light_contribution;  // L f cos / pdf with its MIS weight; 0: no shadow ray needed

#ifdef HM_AOVS
    uint
        emitted_source;  // what emitted, and the source of the light sample: see kSourceEnvironment
    uint light_source;
    // Of camera rays' hits:
    HitFacts facts;
    vec3 diffuse_share;        // the diffuse lobe's part of f towards next_direction
    vec3 light_diffuse_share;  // and towards the light sample
#endif
};

struct ShadowPayload {
    uint key;
    uint index;
    uint visible;
};

// One sample of one pixel.
struct PathSample {
    vec3 radiance;
    float alpha;    // 1 where the ray hit something, or the background is visible
    float removed;  // luminance removed by clamping
    uint rays;
#ifdef HM_AOVS
    // They sum to the radiance.
    vec3 emission;
    vec3 diffuse_direct;
    vec3 specular_direct;
    vec3 diffuse_indirect;
    vec3 specular_indirect;
    vec3 first_diffuse_share;  // PathPayload's, of the first scattering
    bool hit;
    HitFacts facts;  // if it hit
#endif
};

// The state of a path between two steps: its next ray and its throughput. The result of the last
// ray is in the payload.
struct PathState {
    vec3 origin;  // of the next ray
    vec3 direction;
    vec3 throughput;  // product of f cos / pdf so far, over the roulette's survival
    float pdf_bsdf;   // solid-angle density of `direction`; not read for a camera ray
    uint alpha_key;   // what ray_key makes the keys of the path's rays from
};

// The sums of one pixel's samples, in the order of their indices.
struct PixelSum {
    vec3 radiance;  // premultiplied, linear Rec.709
    float alpha;
    float weight;   // how many samples
    float removed;  // luminance removed by --clamp
};

HM_NAMESPACE_END

#endif
