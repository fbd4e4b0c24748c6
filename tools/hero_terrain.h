// The hero scene's mountains: a height field around the terrace, in metres, +y up.
#pragma once

#include <vector>

#include "gltf_writer.h"
#include "shapes.h"

namespace hm {

// Height of the ground at (x, z). The terrace lies at height 0 and looks along -z.
float terrain_height(glm::vec2 xz);

// A fan-shaped height field in front of the terrace, finer around the peaks, and its baked colours
// (linear sampling, u along the azimuth, v along the distance).
TriangleMesh make_terrain();
Picture paint_terrain();

// Positions of trees, with a scale in w.
std::vector<glm::vec4> place_trees(int count);

}  // namespace hm
