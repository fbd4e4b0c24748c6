// What moves a primitive's vertices: morph targets (glTF 2.0, 3.7.2.2) and the joints of a skin
// (3.7.3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shading/structs.h"

namespace hm {

// Only vertices that a target moves are listed, in their order.
template <class T>
struct Delta {
    std::uint32_t vertex;
    T value;
};

struct MorphTarget {
    std::vector<Delta<vec3>> positions, normals, tangents;
    std::vector<Delta<vec2>> uv0, uv1;
    std::vector<Delta<vec4>> colors;
};

// Deltas of normals and tangents need those in the rest vertices, of uv1 and colours the extras.
struct Deformation {
    std::vector<Vertex> rest;
    std::vector<VertexExtra> rest_extras;
    std::vector<MorphTarget> targets;
    // `influences` pairs per vertex, one vertex after the other. A vertex's weights sum to one.
    std::uint32_t influences = 0;
    std::vector<std::uint16_t> joints;
    std::vector<float> weights;

    std::size_t bytes() const;
};

// Deformed copies of the rest vertices. First the targets, as many as there are weights, then the
// joints; without joint matrices the vertices stay in the mesh's own space. Normals are unit length
// or, where they lose their direction, zero.
void deform(const Deformation& deformation, std::span<const float> target_weights,
            std::span<const glm::mat4> joint_matrices, std::vector<Vertex>& vertices,
            std::vector<VertexExtra>& extras);

}  // namespace hm
