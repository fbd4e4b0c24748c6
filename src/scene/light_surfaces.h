// Finite lights that lie on surfaces, such as a lamp in the plane of its ceiling.
#pragma once

#include "scene/flatten.h"

namespace hm {

// Sets surface_normal and surface_error of the lights that lie on a triangle, to within the
// rounding of positions. Needs geometries, instances and lights. Costs a pass over the triangles of
// the instances whose bounds hold a light.
void find_light_surfaces(FlatScene& flat);

}  // namespace hm
