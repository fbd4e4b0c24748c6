// Cameras (glTF 2.0, 3.10) and KHR_lights_punctual's lights.
#pragma once

#include <vector>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

Result<std::vector<Camera>> read_cameras(const Json& root, Source& source);
Result<std::vector<Light>> read_lights(const Json& root, Source& source);

}  // namespace hm::gltf
