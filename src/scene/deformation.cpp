#include "scene/deformation.h"

#include <algorithm>
#include <cmath>

namespace hm {
namespace {

// In double: squares of floats can overflow.
vec3 unit_or_zero(glm::dvec3 v) {
    const double size = glm::length(v);
    return size > 0 && std::isfinite(size) ? vec3(v / size) : vec3(0);
}

struct Morphed {
    bool normals = false, tangents = false, colors = false;
};

Morphed add_target(const MorphTarget& target, float weight, std::vector<Vertex>& vertices,
                   std::vector<VertexExtra>& extras) {
    for (const auto& d : target.positions)
        vertices[d.vertex].position += weight * d.value;
    for (const auto& d : target.normals)
        vertices[d.vertex].normal += weight * d.value;
    for (const auto& d : target.tangents)
        vertices[d.vertex].tangent += vec4(weight * d.value, 0);
    for (const auto& d : target.uv0)
        vertices[d.vertex].uv0 += weight * d.value;
    for (const auto& d : target.uv1)
        extras[d.vertex].uv1 += weight * d.value;
    for (const auto& d : target.colors)
        extras[d.vertex].color += weight * d.value;
    return {!target.normals.empty(), !target.tangents.empty(), !target.colors.empty()};
}

void morph(const std::vector<MorphTarget>& targets, std::span<const float> weights,
           std::vector<Vertex>& vertices, std::vector<VertexExtra>& extras) {
    Morphed any;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (weights[i] == 0) continue;
        const Morphed here = add_target(targets[i], weights[i], vertices, extras);
        any = {any.normals || here.normals, any.tangents || here.tangents,
               any.colors || here.colors};
    }
    for (Vertex& v : vertices) {
        if (any.normals) v.normal = unit_or_zero(glm::dvec3(v.normal));
        if (any.tangents) v.tangent = vec4(unit_or_zero(glm::dvec3(v.tangent)), v.tangent.w);
    }
    if (any.colors)
        for (VertexExtra& e : extras)
            e.color = clamp(e.color, vec4(0), vec4(1));
}

// Linear blend skinning: the vertex is transformed by the weighted sum of the joint matrices.
void skin(const Deformation& d, std::span<const glm::mat4> joint_matrices,
          std::vector<Vertex>& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        glm::dmat4 m(0);
        for (std::size_t k = i * d.influences; k < (i + 1) * d.influences; ++k)
            if (d.weights[k] != 0)
                m += glm::dmat4(joint_matrices[d.joints[k]]) * double(d.weights[k]);
        Vertex& v = vertices[i];
        v.position = vec3(m * glm::dvec4(v.position, 1));
        // Normals are transformed by the cofactor matrix, that is the inverse transpose times the
        // determinant, whose sign is removed again. It exists for singular matrices too.
        const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
        const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
        const double side = glm::dot(x, cofactors[0]) < 0 ? -1 : 1;
        v.normal = unit_or_zero(cofactors * glm::dvec3(v.normal) * side);
        v.tangent = vec4(unit_or_zero(glm::dmat3(m) * glm::dvec3(v.tangent)), v.tangent.w);
    }
}

template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

}  // namespace

std::size_t Deformation::bytes() const {
    std::size_t sum = bytes_of(rest) + bytes_of(rest_extras) + bytes_of(joints) + bytes_of(weights);
    for (const MorphTarget& t : targets)
        sum += sizeof t + bytes_of(t.positions) + bytes_of(t.normals) + bytes_of(t.tangents) +
               bytes_of(t.uv0) + bytes_of(t.uv1) + bytes_of(t.colors);
    return sum;
}

void deform(const Deformation& deformation, std::span<const float> target_weights,
            std::span<const glm::mat4> joint_matrices, std::vector<Vertex>& vertices,
            std::vector<VertexExtra>& extras) {
    vertices = deformation.rest;
    extras = deformation.rest_extras;
    morph(deformation.targets, target_weights, vertices, extras);
    if (!joint_matrices.empty()) skin(deformation, joint_matrices, vertices);
}

}  // namespace hm
