// The path tracer's stages, in the order that each needs the ones before. Included once, in C++
// inside the body of a struct that has the tables and hooks as members, in GLSL after the tables'
// declarations.
// clang-format off
#include "shading/path/sampler.h"
#include "shading/texture/lookup.h"
#include "shading/material/textures.h"
#include "shading/path/surface.h"
#include "shading/material/material.h"
#include "shading/material/bsdf.h"
#include "shading/material/extended_lobes.h"
#include "shading/light/light.h"
#include "shading/path/any_hit.h"
#include "shading/path/closest_hit.h"
#include "shading/path/miss.h"
#include "shading/path/steps.h"
#include "shading/path/ray_generation.h"
#include "shading/path/finish.h"
// clang-format on
