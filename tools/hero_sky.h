// The hero scene's sky as an environment map, without the sun's disc: the sun is a directional
// light of the scene.
#pragma once

#include <filesystem>

#include <glm/glm.hpp>

#include "base/result.h"

namespace hm {

// Unit vector towards the sun, which is low and to the left.
glm::vec3 hero_sun_direction();

// Equirectangular, 1024 x 512: u = 0.5 + atan2(z, x) / 2 pi, v = acos(y) / pi.
Result<void> write_hero_sky(const std::filesystem::path& path);

}  // namespace hm
