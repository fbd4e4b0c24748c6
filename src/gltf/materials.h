// Materials (glTF 2.0, 3.9), driven by the parameter list (scene/material_parameters.h), with
// KHR_texture_transform and KHR_materials_unlit, and their textures and samplers (3.8).
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// The slots' `image` are indices into the file's images, which are read later.
Result<std::vector<Material>> read_materials(const Json& root, Source& source);

}  // namespace hm::gltf
