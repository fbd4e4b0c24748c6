// The hero scene's sky as a picture of radiance around the viewer, without the sun's disc: the sun
// is the scene's directional light.
#pragma once

#include <filesystem>

#include <glm/glm.hpp>

#include "base/result.h"

namespace hm {

// Towards the sun, unit; low in the left.
glm::vec3 hero_sun_direction();

// Equirectangular, 1024 x 512: u = 0.5 + atan2(z, x) / 2 pi, v = acos(y) / pi.
Result<void> write_hero_sky(const std::filesystem::path& path);

}  // namespace hm
