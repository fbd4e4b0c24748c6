// What the stages of the path tracer hand each other.
#ifndef HM_SHADING_PATH_TYPES_H
#define HM_SHADING_PATH_TYPES_H

#include "shading/structs.h"

HM_NAMESPACE_BEGIN

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

// Ray generation writes the first block, closest hit or miss the rest. Both payloads begin with
// `key`, which any-hit reads.
struct PathPayload {
    uint key;  // of this ray's stochastic alpha
    uint pixel_x;
    uint pixel_y;
    uint index;   // of the sample
    uint bounce;  // scattering events before this ray; 0: a camera ray

    float hit_distance;   // < 0: a miss
    uint passed_through;  // 1: a camera ray met a single-sided back face; go on at next_origin
    vec3 emitted;         // radiance towards the ray's origin
    float emitted_pdf;    // solid-angle density with which light sampling finds this; 0: never
    vec3 next_origin;
    vec3 next_direction;
    vec3 weight;           // f cos / pdf; 0 ends the path
    float pdf;             // of next_direction, whole mixture of lobes
    uint roulette;         // this bounce's number for Russian roulette
    vec3 light_direction;  // one light sample, visibility not yet known
    float light_distance;
    vec3 light_contribution;  // L f cos / pdf with its MIS weight; 0: no need to trace
};

struct ShadowPayload {
    uint key;
    uint visible;
};

// One sample of one pixel.
struct PathSample {
    vec3 radiance;
    float alpha;    // 1 where something or a visible background was seen
    float removed;  // luminance that clamping took away
    uint rays;
};

// The sums of one pixel's samples, in the order of their indices.
struct PixelSum {
    vec3 radiance;  // premultiplied, linear Rec.709
    float alpha;
    float weight;   // how many samples
    float removed;  // luminance that --clamp took away
};

HM_NAMESPACE_END

#endif
