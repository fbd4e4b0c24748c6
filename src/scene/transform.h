// A node's local transform, decomposed: translation * rotation * scale. In double precision:
// georeferenced files have nodes millions of metres from the origin.
#pragma once

#include "shading/lang.h"

namespace hm {

struct Transform {
    glm::dvec3 translation{0};        // metres
    glm::dvec4 rotation{0, 0, 0, 1};  // quaternion x, y, z, w; of any nonzero length
    glm::dvec3 scale{1};
};

glm::dmat4 to_matrix(const Transform& transform);

// The nearest that 32-bit floats hold.
Transform round_to_floats(const Transform& transform);

// Vectors with a smaller squared length have no direction: the square has lost its precision.
inline constexpr float kLeastSquaredLength = 1e-30f;

// Whether a camera or light with this transform has a valid direction along -z, which it has not if
// scaled to zero.
bool has_direction(const glm::mat4& to_world);

}  // namespace hm
