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

}  // namespace hm
