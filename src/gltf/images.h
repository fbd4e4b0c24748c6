// Images (glTF 2.0, 3.8.3): fetches their bytes and decodes them in parallel.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// Decodes the images that the materials in `used` read, and changes the slots' `image` from indices
// of the file to indices of the result; slots of images that are not read become kUnset.
Result<std::vector<TextureImage>> read_images(const Json& root, Source& source,
                                              std::vector<Material>& materials,
                                              const std::vector<bool>& used);

}  // namespace hm::gltf
