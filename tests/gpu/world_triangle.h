// A triangle as brute_force.h intersects it: in world space, with its ids.
#ifndef HM_TESTS_GPU_WORLD_TRIANGLE_H
#define HM_TESTS_GPU_WORLD_TRIANGLE_H

#include "shading/path/types.h"

HM_NAMESPACE_BEGIN

struct WorldTriangle {
    vec3 p0;
    vec3 p1;
    vec3 p2;
    HitIds ids;
};

HM_NAMESPACE_END

#endif
