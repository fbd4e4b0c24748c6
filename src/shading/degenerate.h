// Which triangles no ray hits: both builders of acceleration structures leave them out. C++ only.
#pragma once

#include <cmath>
#include <initializer_list>

#include "shading/lang.h"

namespace hm {

// A corner that is not a number, or no area (in double, where the products of float coordinates
// don't vanish).
inline bool is_degenerate(vec3 a, vec3 b, vec3 c) {
    for (const vec3& p : {a, b, c})
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return true;
    const glm::dvec3 origin(a);
    const glm::dvec3 normal = glm::cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin);
    return normal == glm::dvec3(0);
}

}  // namespace hm
