// Light groups: one group for each punctual light of the file, one for each emissive material, and
// one for the environment with the background.
#pragma once

#include <string>
#include <vector>

#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm {

struct LightGroups {
    std::vector<std::string> names;  // unique, valid as part of a layer name
    // Group of each light source, indexed as defined at kSourceEnvironment in shading/path/types.h.
    std::vector<std::uint32_t> source_groups;
};

LightGroups find_light_groups(const Scene& scene, const FlatScene& flat);

}  // namespace hm
