// From a primitive's topology and indices to a triangle list.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace hm::gltf {

// The values are glTF's primitive modes.
enum class Topology : std::uint32_t { triangles = 4, strip = 5, fan = 6 };

// Vertices in drawing order, packed as the triangles that most of them are to be: the last three
// may be more than there are.
struct Indices {
    std::vector<uvec3> packed;
    std::size_t count = 0;

    explicit Indices(std::size_t n) : packed(n / 3 + (n % 3 == 0 ? 0 : 1)), count(n) {}
    std::span<std::uint32_t> each() { return {packed.empty() ? nullptr : &packed[0].x, count}; }
};

// Every triangle has the winding that glTF 2.0, 3.7.2.1 gives it. Indices that complete no triangle
// are left out.
std::vector<uvec3> make_triangles(Topology topology, Indices indices);

// Drops vertices that no triangle uses where there must be such: primitives of one mesh often share
// a vertex buffer, and each would keep all of it. Returns the former indices of the vertices that
// are left, or nothing where all are.
std::vector<std::uint32_t> drop_unused_vertices(Primitive& primitive);

}  // namespace hm::gltf
