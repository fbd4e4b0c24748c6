// The scene's emissive triangles and the alias table that samples them by power.
#pragma once

#include "scene/flatten.h"

namespace hm {

// Fills emitters, emitter_alias, emitter_power and the offsets that map a hit to its emitter. The
// power of a triangle is the integral of texture times factor over its area, times the number of
// emitting sides.
void add_emitters(FlatScene& flat);

}  // namespace hm
