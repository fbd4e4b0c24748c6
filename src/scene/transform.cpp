#include "scene/transform.h"

namespace hm {
namespace {

glm::dmat3 rotation_matrix(const glm::dvec4& q) {
    const double two = 2 / glm::dot(q, q);  // the quaternion may have any length
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    return glm::dmat3(1 - two * (y * y + z * z), two * (x * y + z * w), two * (x * z - y * w),
                      two * (x * y - z * w), 1 - two * (x * x + z * z), two * (y * z + x * w),
                      two * (x * z + y * w), two * (y * z - x * w), 1 - two * (x * x + y * y));
}

// Through memory: g++ 12 vectorizes conversions of neighbouring numbers to floats and back, and
// leaves out some of them (Origin.NearScenesAreRoundedToFloats).
double round_to_float(double x) {
    const volatile float rounded = float(x);
    return double(rounded);
}

}  // namespace

glm::dmat4 to_matrix(const Transform& transform) {
    const glm::dmat3 rotation = rotation_matrix(transform.rotation);
    glm::dmat4 out(1);
    for (int column = 0; column < 3; ++column)
        out[column] = glm::dvec4(rotation[column] * transform.scale[column], 0);
    out[3] = glm::dvec4(transform.translation, 1);
    return out;
}

Transform round_to_floats(const Transform& t) {
    Transform out;
    for (int i = 0; i < 3; ++i) {
        out.translation[i] = round_to_float(t.translation[i]);
        out.scale[i] = round_to_float(t.scale[i]);
    }
    for (int i = 0; i < 4; ++i)
        out.rotation[i] = round_to_float(t.rotation[i]);
    return out;
}

bool has_direction(const glm::mat4& to_world) {
    const vec3 axis(to_world[2]);
    return dot(axis, axis) > kLeastSquaredLength;
}

}  // namespace hm
