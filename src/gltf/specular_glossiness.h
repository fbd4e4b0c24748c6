// KHR_materials_pbrSpecularGlossiness: an archived extension that many shared models carry. It
// replaces the metallic-roughness factors and textures of its material.
#pragma once

#include <string_view>
#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "gltf/textures.h"
#include "scene/scene.h"

namespace hm::gltf {

inline constexpr std::string_view kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

// Replaces the material's colour, metallic and roughness by the extension's values, if it has them:
// a dielectric whose reflectance at normal incidence is the specular colour, f90 one, and whose
// diffuse base is dimmed by what the reflection takes (the extension: by the largest component of
// the specular colour). Values outside 0 to 1 are clamped with a warning.
Result<void> read_specular_glossiness(const Json& json, const std::vector<Texture>& textures,
                                      Source& source, Material& material);

}  // namespace hm::gltf
