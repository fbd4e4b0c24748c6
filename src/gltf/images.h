// Images (glTF 2.0, 3.8.3): fetching their bytes and decoding them in parallel.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// Decodes the images that the materials in `used` read and turns the slots' `image` from the file's
// indices into the result's; slots of images that are not read become unset.
Result<std::vector<TextureImage>> read_images(const Json& root, Source& source,
                                              std::vector<Material>& materials,
                                              const std::vector<bool>& used);

}  // namespace hm::gltf
