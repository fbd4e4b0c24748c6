// The film's planes: float channels that AOVs are accumulated in, with one or more values per
// pixel. Both renderers write them; film/aov turns them into layers of a file.
#ifndef HM_SHADING_PATH_AOV_PLANES_H
#define HM_SHADING_PATH_AOV_PLANES_H

#include "shading/lang.h"

HM_NAMESPACE_BEGIN

// Sums over all samples.
HM_CONST uint kPlaneAlbedo = 0u;           // 3 floats
HM_CONST uint kPlaneMetallic = 1u;         // 1
HM_CONST uint kPlaneRoughness = 2u;        // 1
HM_CONST uint kPlaneNormal = 3u;           // 3, world space
HM_CONST uint kPlaneGeometricNormal = 4u;  // 3
HM_CONST uint kPlaneEmission = 5u;         // 3, as the next four
HM_CONST uint kPlaneDiffuseDirect = 6u;
HM_CONST uint kPlaneSpecularDirect = 7u;
HM_CONST uint kPlaneDiffuseIndirect = 8u;
HM_CONST uint kPlaneSpecularIndirect = 9u;
HM_CONST uint kPlaneLightGroups = 10u;  // 3 per group
HM_CONST uint kPlaneReplicates = 11u;   // 4 per replicate: radiance and how many samples
HM_CONST uint kPlaneSquares = 12u;      // 3: radiance squared
// Sums over the samples that hit; the last float counts those.
HM_CONST uint kPlaneDepth = 13u;     // 2
HM_CONST uint kPlanePosition = 14u;  // 4, world space
// Of the lowest sample index that hit; the last float is that index + 1, or 0 before any.
HM_CONST uint kPlaneUv = 15u;          // 3
HM_CONST uint kPlaneMotion = 16u;      // 3
HM_CONST uint kPlaneMaterialId = 17u;  // 2: index + 1
HM_CONST uint kPlaneInstanceId = 18u;  // 2: index + 1
HM_CONST uint kPlaneCount = 19u;

// Sobol samples have no usable variance of their own: sample i belongs to replicate i mod 4, each
// scrambled on its own.
HM_CONST uint kReplicates = 4u;

HM_NAMESPACE_END

#endif
