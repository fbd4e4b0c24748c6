// Textures, samplers and the references that materials hold to them.
#pragma once

#include <string_view>
#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

struct Texture {
    TextureSlot slot;  // image and sampler; identity transform
    // An extension's image format, where that is the texture's only source.
    std::string_view extension;
};

Result<std::vector<Texture>> read_textures(const Json& root);

// A material's "...Texture" object.
Result<TextureSlot> read_texture_slot(const Json& info, const std::vector<Texture>& textures,
                                      Source& source);

}  // namespace hm::gltf
