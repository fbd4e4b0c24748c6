// What TestScene (path_tracer.h) has not: shapes and placements that the two renderers build their
// acceleration structures from in different ways.
#pragma once

#include "scene/flatten.h"

namespace hm::test {

// A room with a mesh that morphs, one that wears a skin, one instanced four times, one placed twice
// at the same place, one scaled by a billionth and its vertices by a billion, triangles without
// area, and a picture of 16 bits per channel.
struct OddScene {
    Scene scene;
    FlatScene flat;
    CameraData camera{};

    OddScene();
};

}  // namespace hm::test
