// What surfaces are called, for cryptomattes. A surface is one geometry of one instance; they are
// numbered instance by instance.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm {

// The number of each instance's first surface, and at the end how many there are.
std::vector<std::uint32_t> first_surfaces(const FlatScene& flat);

// By surface. Surfaces that share a name are one object, material or asset.
struct SurfaceNames {
    std::vector<std::string> objects;  // the node's name, with [N] for one of its instances
    std::vector<std::string> materials;
    std::vector<std::string> assets;  // the name of the node at the root above it
};

SurfaceNames name_surfaces(const Scene& scene, const FlatScene& flat);

}  // namespace hm
