#include "gltf/transform.h"

#include <array>
#include <cmath>

namespace hm::gltf {
namespace {

Result<glm::dmat4> read_matrix(const Json& node) {
    std::array<double, 16> m{};
    HM_TRY(node.numbers("matrix", m));
    const auto matrix = affine_matrix(m);
    if (!matrix) return node.invalid("matrix", "its last row is not 0 0 0 1");
    return *matrix;
}

template <class Vector>
Result<void> read_vector(const Json& node, std::string_view key, Vector& out) {
    HM_TRY(node.numbers(key, std::span<double>(&out[0], std::size_t(Vector::length()))));
    return {};
}

}  // namespace

std::optional<glm::dmat4> affine_matrix(std::span<const double, 16> columns) {
    // Exporters write the last row with rounding errors; larger deviations are projections.
    constexpr double kTolerance = 1e-4;
    glm::dmat4 out(1);
    for (int column = 0; column < 4; ++column) {
        const double* from = columns.data() + 4 * column;
        if (!(std::abs(from[3] - out[column][3]) <= kTolerance)) return std::nullopt;
        for (int row = 0; row < 3; ++row)
            out[column][row] = from[row];
    }
    return out;
}

Result<void> read_transform(const Json& json, Node& node) {
    if (json.has("matrix")) {
        if (json.has("translation") || json.has("rotation") || json.has("scale"))
            return json.invalid("matrix",
                                "a node has either a matrix or translation, rotation and scale, "
                                "not both");
        HM_TRY_ASSIGN(node.local, read_matrix(json));
        return {};
    }
    Transform& rest = node.rest.emplace();
    HM_TRY(read_vector(json, "translation", rest.translation));
    HM_TRY(read_vector(json, "scale", rest.scale));
    HM_TRY(read_vector(json, "rotation", rest.rotation));
    if (rest.rotation == glm::dvec4(0))
        return json.invalid("rotation", "must not be a zero quaternion");
    node.local = to_matrix(rest);
    return {};
}

}  // namespace hm::gltf
