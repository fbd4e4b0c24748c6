// The scene's emissive triangles and their alias table over power.
#pragma once

#include "scene/flatten.h"

namespace hm {

// Fills emitters, emitter_alias, emitter_power and the offsets that lead from a hit to its emitter.
// A triangle's power is the integral of texture times factor over its area, times its emitting
// sides.
void add_emitters(FlatScene& flat);

}  // namespace hm
