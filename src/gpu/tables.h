// Structs of the GPU's buffers that shading/ does not have: GLSL and C++ at once, layout(scalar).
#ifndef HM_GPU_TABLES_H
#define HM_GPU_TABLES_H

#include "shading/path/aov_planes.h"
#include "shading/structs.h"

HM_NAMESPACE_BEGIN

// Bindings of set 0. The tables of shading/tables.inl follow in its order.
HM_CONST uint kFrameBinding = 0u;
HM_CONST uint kStructureBinding = 1u;
HM_CONST uint kGeometryAddressesBinding = 2u;
HM_CONST uint kFirstTableBinding = 3u;

// Where a geometry's arrays lie: device addresses, the low word first.
struct GeometryAddresses {
    uvec2 vertices;
    uvec2 extras;  // 0 without kGeometryHasExtras
    uvec2 triangles;
};

// Push constants of the path tracer: which samples of which pixels a launch adds.
struct TraceRange {
    uint crop_x;  // the picture's pixel at (0, 0) of the accumulation image
    uint crop_y;
    uint first_row;  // of the image; the launch says how many rows
    uint sample_begin;
    uint sample_end;
    uvec2 hits;          // address of the SampleHits that the AOV build writes; 0: not requested
    uint noted_begin;    // first sample recorded there
    uint noted_samples;  // of each pixel, consecutive
};

// What the AOV build of the path tracer reads and writes, by device address.
struct AovAddresses {
    uvec2 planes[kPlaneCount];  // of the film; 0: not requested
    uvec2 next_transforms;      // mat4x3, of instances
    uvec2 next_positions;       // uvec2, of geometries: vec3 of vertices; 0: unchanged
};

// What one sample hit: instance kNone for nothing.
struct SampleHit {
    uint instance;
    uint geometry;  // within the instance's mesh
};

// Launches count rays and non-finite samples in this many rows, to reduce contention of atomics.
HM_CONST uint kCounterRows = 256u;
struct TraceCounters {
    uint rays;
    uint non_finite;
};

// Rays as the recording build of the path tracer stores them: ray k of pixel p at k * pixels + p.
HM_CONST uint kRecordedClosest = 1u;
HM_CONST uint kRecordedShadow = 2u;
struct RecordedRay {
    vec3 origin;
    float t_max;
    vec3 direction;
    uint kind;  // kRecorded*
};

// How many rays of a pixel were recorded, and how many of them are shadow rays.
struct RecordedCounts {
    uint rays;
    uint shadow_rays;
};

// Push constants of the bare tracer.
struct BareRange {
    uint pixels;
    uint kinds;  // kRecorded*, one or both
};

HM_NAMESPACE_END

#ifdef __cplusplus
namespace hm {
// The uniform block at kFrameBinding.
struct FrameData {
#define HM_FRAME_VALUE(Type, name) Type name;
#include "shading/tables.inl"
};

static_assert(sizeof(RecordedRay) == 32 && sizeof(BareRange) == 8);
static_assert(sizeof(GeometryAddresses) == 24 && sizeof(TraceRange) == 36);
}  // namespace hm
#endif

#endif
