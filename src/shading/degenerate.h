// Degenerate triangles, which no ray hits: both acceleration structure builders skip them. C++
// only.
#pragma once

#include <cmath>
#include <initializer_list>

#include "shading/lang.h"

namespace hm {

// A corner with a NaN or an infinity, or no area (in double, where products of float coordinates do
// not underflow).
inline bool is_degenerate(vec3 a, vec3 b, vec3 c) {
    for (const vec3& p : {a, b, c})
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return true;
    const glm::dvec3 origin(a);
    const glm::dvec3 normal = glm::cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin);
    return normal == glm::dvec3(0);
}

}  // namespace hm
