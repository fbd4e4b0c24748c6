// Materials (glTF 2.0, 3.9) with KHR_texture_transform, KHR_materials_emissive_strength and
// KHR_materials_unlit, and the textures and samplers they use (3.8).
#pragma once

#include <array>
#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// The slots' `image` are indices of the file's images; images are not read yet.
Result<std::vector<Material>> read_materials(const Json& root, Source& source);

// Every slot of a material.
std::array<const TextureSlot*, 5> texture_slots(const Material& material);
std::array<TextureSlot*, 5> texture_slots(Material& material);

}  // namespace hm::gltf
