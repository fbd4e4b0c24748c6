// A scene of materials with extensions.
#pragma once

#include "scene/flatten.h"

namespace hm::test {

// Spheres in a lit room: each extension with its textures, glass within glass, and the camera
// inside a tinted volume that fills the room.
struct ExtendedScene {
    Scene scene;
    FlatScene flat;
    CameraData camera{};

    ExtendedScene();
};

}  // namespace hm::test
