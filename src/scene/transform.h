// A node's own transform as its parts: translation * rotation * scale.
#pragma once

#include "shading/lang.h"

namespace hm {

struct Transform {
    vec3 translation{0};        // metres
    vec4 rotation{0, 0, 0, 1};  // quaternion x, y, z, w; any length but zero
    vec3 scale{1};
};

glm::mat4 to_matrix(const Transform& transform);

// Shorter vectors have no direction: the square has lost its digits.
inline constexpr float kLeastSquaredLength = 1e-30f;

// Whether a camera or lamp in this space still looks somewhere, along -z: not if it is scaled to
// nothing.
bool has_direction(const glm::mat4& to_world);

}  // namespace hm
