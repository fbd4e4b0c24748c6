#include "gltf/transform.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace hm::gltf {
namespace {

Result<glm::mat4> read_matrix(const Json& node) {
    std::array<float, 16> m{};  // columns, as glm has them
    HM_TRY(node.numbers("matrix", m));
    // Exporters write the last row with rounding errors; more than that is a projection.
    constexpr float kTolerance = 1e-4f;
    if (std::abs(m[3]) > kTolerance || std::abs(m[7]) > kTolerance ||
        std::abs(m[11]) > kTolerance || std::abs(m[15] - 1) > kTolerance)
        return node.invalid("matrix", "its last row is not 0 0 0 1");
    glm::mat4 out(1);
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 3; ++row)
            out[column][row] = m[4 * column + row];
    return out;
}

// The rotation of a quaternion x, y, z, w, which need not have unit length.
Result<glm::dmat3> read_rotation(const Json& node) {
    std::array<float, 4> q{0, 0, 0, 1};
    HM_TRY(node.numbers("rotation", q));
    double x = double{q[0]}, y = double{q[1]}, z = double{q[2]}, w = double{q[3]};
    const double size = std::sqrt(x * x + y * y + z * z + w * w);
    if (size == 0) return node.invalid("rotation", "a zero quaternion is no rotation");
    x /= size, y /= size, z /= size, w /= size;
    return glm::dmat3(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),
                      2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
                      2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y));
}

}  // namespace

Result<glm::mat4> read_transform(const Json& node) {
    const bool has_parts = node.has("translation") || node.has("rotation") || node.has("scale");
    if (node.has("matrix")) {
        if (has_parts)
            return node.invalid("matrix",
                                "a node has a matrix or translation, rotation and scale, "
                                "not both");
        return read_matrix(node);
    }
    if (!has_parts) return glm::mat4(1);
    std::array<float, 3> translation{0, 0, 0};
    std::array<float, 3> scale{1, 1, 1};
    HM_TRY(node.numbers("translation", translation));
    HM_TRY(node.numbers("scale", scale));
    HM_TRY_ASSIGN(const glm::dmat3 rotation, read_rotation(node));
    glm::mat4 out(1);
    for (std::size_t column = 0; column < 3; ++column)
        out[column] = vec4(vec3(rotation[column] * double{scale[column]}), 0);
    out[3] = vec4(translation[0], translation[1], translation[2], 1);
    return out;
}

}  // namespace hm::gltf
