// Converts a primitive's topology and indices to a triangle list.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace hm::gltf {

// The values are glTF's primitive modes.
enum class Topology : std::uint32_t { triangles = 4, strip = 5, fan = 6 };

// Vertex indices, stored as triangles so that triangle lists need no copy. The last triangle may be
// incomplete.
struct Indices {
    std::vector<uvec3> packed;
    std::size_t count = 0;

    explicit Indices(std::size_t n) : packed(n / 3 + (n % 3 == 0 ? 0 : 1)), count(n) {}
    std::span<std::uint32_t> each() { return {packed.empty() ? nullptr : &packed[0].x, count}; }
};

// Triangles have the winding of glTF 2.0, 3.7.2.1. Indices that do not complete a triangle are
// dropped.
std::vector<uvec3> make_triangles(Topology topology, Indices indices);

// Drops unused vertices if there are more vertices than the triangles can use: primitives of one
// mesh often share a vertex buffer, and each would keep all of it. Returns the former indices of
// the remaining vertices, or an empty list if all are kept.
std::vector<std::uint32_t> drop_unused_vertices(Primitive& primitive);

}  // namespace hm::gltf
