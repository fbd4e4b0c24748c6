// What TestScene (path_tracer.h) lacks: shapes and placements for which the two renderers build
// their acceleration structures differently.
#pragma once

#include "scene/flatten.h"

namespace hm::test {

// A room with a morphed mesh, a skinned one, one instanced four times, one placed twice by the same
// transform, one scaled by 1e-9 with vertices scaled by 1e9, triangles without area, and an image
// of 16 bits per channel.
struct OddScene {
    Scene scene;
    FlatScene flat;
    CameraData camera{};

    OddScene();
};

}  // namespace hm::test
