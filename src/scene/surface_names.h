// Names of surfaces, for Cryptomatte. A surface is one geometry of one instance; surfaces are
// numbered instance by instance.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm {

// Index of each instance's first surface, followed by the total number of surfaces.
std::vector<std::uint32_t> first_surfaces(const FlatScene& flat);

// Indexed by surface. Surfaces with the same name are the same object, material or asset.
struct SurfaceNames {
    std::vector<std::string> objects;  // node name, with [N] appended for its N-th instance
    std::vector<std::string> materials;
    std::vector<std::string> assets;  // name of the node's root ancestor
};

SurfaceNames name_surfaces(const Scene& scene, const FlatScene& flat);

}  // namespace hm
