// Vertex deformation of a primitive: morph targets (glTF 2.0, 3.7.2.2) and skinning by joints
// (3.7.3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shading/structs.h"

namespace hm {

// Sparse: only vertices that a target changes are listed, in ascending order.
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

// Deltas of normals and tangents require normals and tangents in the rest vertices; deltas of uv1
// and colours require the extras.
struct Deformation {
    std::vector<Vertex> rest;
    std::vector<VertexExtra> rest_extras;
    std::vector<MorphTarget> targets;
    // `influences` (joint, weight) pairs per vertex, vertex by vertex. The weights of a vertex sum
    // to one.
    std::uint32_t influences = 0;
    std::vector<std::uint16_t> joints;
    std::vector<float> weights;

    std::size_t bytes() const;
};

// Writes deformed copies of the rest vertices. Morph targets come first, one per weight, then the
// joints; without joint matrices the vertices stay in the mesh's own space. Normals are unit
// length, or zero if they degenerate.
void deform(const Deformation& deformation, std::span<const float> target_weights,
            std::span<const glm::mat4> joint_matrices, std::vector<Vertex>& vertices,
            std::vector<VertexExtra>& extras);

}  // namespace hm
