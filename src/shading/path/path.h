// The path tracer's stages, in the order that each needs the ones before. Included once, in C++
// inside the body of a struct that has the tables and hooks as members, in GLSL after the tables'
// declarations.
// clang-format off
#include "shading/path/sampler.h"
#include "shading/path/texture.h"
#include "shading/path/surface.h"
#include "shading/path/bsdf.h"
#include "shading/path/environment.h"
#include "shading/path/emission.h"
#include "shading/path/light_sampling.h"
#include "shading/path/any_hit.h"
#include "shading/path/closest_hit.h"
#include "shading/path/miss.h"
#include "shading/path/ray_generation.h"
#include "shading/path/accumulate.h"
// clang-format on
