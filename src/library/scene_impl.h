// What a public Scene holds.
#pragma once

#include <himalaya/scene.h>

#include <string>
#include <vector>

#include "gltf/load.h"
#include "scene/scene.h"

namespace himalaya {

struct Scene::Impl {
    hm::Scene scene;
    hm::LoadOptions load;               // what of the file was read
    std::vector<std::string> warnings;  // of loading
    // A mesh was added since tangents were last prepared.
    bool lacks_tangents = false;
    // An instance was added since the origin was last chosen.
    bool lacks_origin = false;
};

}  // namespace himalaya
