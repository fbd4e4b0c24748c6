// Materials (glTF 2.0, 3.9) by the list of their parameters (scene/material_parameters.h), with
// KHR_texture_transform and KHR_materials_unlit, and the textures and samplers they use (3.8).
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// The slots' `image` are indices of the file's images; images are not read yet.
Result<std::vector<Material>> read_materials(const Json& root, Source& source);

}  // namespace hm::gltf
