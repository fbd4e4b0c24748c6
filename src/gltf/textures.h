// Textures, samplers and the texture references of materials.
#pragma once

#include <string_view>
#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

struct Texture {
    TextureSlot slot;  // image and sampler; identity transform
    // The image format extension, if it is the texture's only source.
    std::string_view extension;
};

Result<std::vector<Texture>> read_textures(const Json& root);

// Reads a textureInfo object of a material.
Result<TextureSlot> read_texture_slot(const Json& info, const std::vector<Texture>& textures,
                                      Source& source);

}  // namespace hm::gltf
