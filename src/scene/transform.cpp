#include "scene/transform.h"

namespace hm {
namespace {

glm::dmat3 rotation_matrix(const vec4& rotation) {
    const glm::dvec4 q(rotation);
    const double two = 2 / glm::dot(q, q);  // the quaternion may have any length
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    return glm::dmat3(1 - two * (y * y + z * z), two * (x * y + z * w), two * (x * z - y * w),
                      two * (x * y - z * w), 1 - two * (x * x + z * z), two * (y * z + x * w),
                      two * (x * z + y * w), two * (y * z - x * w), 1 - two * (x * x + y * y));
}

}  // namespace

glm::mat4 to_matrix(const Transform& transform) {
    const glm::dmat3 rotation = rotation_matrix(transform.rotation);
    glm::mat4 out(1);
    for (int column = 0; column < 3; ++column)
        out[column] = vec4(vec3(rotation[column] * double(transform.scale[column])), 0);
    out[3] = vec4(transform.translation, 1);
    return out;
}

bool has_direction(const glm::mat4& to_world) {
    const vec3 axis(to_world[2]);
    return dot(axis, axis) > kLeastSquaredLength;
}

}  // namespace hm
