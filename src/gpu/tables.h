// What the GPU's tables hold beside the structs of shading/: GLSL and C++ at once, layout(scalar).
#ifndef HM_GPU_TABLES_H
#define HM_GPU_TABLES_H

#include "shading/structs.h"

HM_NAMESPACE_BEGIN

// Set 0, binding 0: all that is the same for every ray of a picture.
struct FrameData {
    RenderParams params;
    CameraData camera;
    EnvironmentData environment;
};

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
};

// Launches count rays and faulty samples into this many rows, so that not all pixels meet at one.
HM_CONST uint kCounterRows = 256u;
struct TraceCounters {
    uint rays;
    uint non_finite;
};

HM_NAMESPACE_END

#ifdef __cplusplus
namespace hm {
static_assert(sizeof(GeometryAddresses) == 24 && sizeof(TraceRange) == 20);
static_assert(sizeof(FrameData) ==
              sizeof(RenderParams) + sizeof(CameraData) + sizeof(EnvironmentData));
}  // namespace hm
#endif

#endif
