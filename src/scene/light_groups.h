// Light groups: each punctual light of the file, each emissive material, and the environment with
// the background form a group of their own.
#pragma once

#include <string>
#include <vector>

#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm {

struct LightGroups {
    std::vector<std::string> names;  // unique, usable in the name of a layer
    // Of each source of light, as kSourceEnvironment in shading/path/types.h numbers them.
    std::vector<std::uint32_t> source_groups;
};

LightGroups find_light_groups(const Scene& scene, const FlatScene& flat);

}  // namespace hm
