#include "gltf/triangles.h"

namespace hm::gltf {

std::vector<uvec3> make_triangles(Topology topology, Indices indices) {
    if (topology == Topology::triangles) {
        indices.packed.resize(indices.count / 3);
        return std::move(indices.packed);
    }
    std::vector<uvec3> out;
    if (indices.count < 3) return out;
    out.reserve(indices.count - 2);
    const std::span<const std::uint32_t> each = indices.each();
    for (std::size_t i = 0; i + 2 < each.size(); ++i) {
        if (topology == Topology::fan)
            out.emplace_back(each[i + 1], each[i + 2], each[0]);
        else  // every second triangle of a strip is reversed
            out.emplace_back(each[i], each[i + 1 + i % 2], each[i + 2 - i % 2]);
    }
    return out;
}

std::vector<std::uint32_t> drop_unused_vertices(Primitive& primitive) {
    if (primitive.vertices.size() <= 3 * primitive.triangles.size()) return {};
    std::vector<std::uint32_t> kept;
    std::vector<std::uint32_t> new_index(primitive.vertices.size(), kNone);
    std::vector<Vertex> vertices;
    std::vector<VertexExtra> extras;
    for (uvec3& triangle : primitive.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            std::uint32_t& moved = new_index[triangle[c]];
            if (moved == kNone) {
                moved = static_cast<std::uint32_t>(vertices.size());
                kept.push_back(triangle[c]);
                vertices.push_back(primitive.vertices[triangle[c]]);
                if (!primitive.extras.empty()) extras.push_back(primitive.extras[triangle[c]]);
            }
            triangle[c] = moved;
        }
    }
    vertices.shrink_to_fit();
    extras.shrink_to_fit();
    primitive.vertices = std::move(vertices);
    primitive.extras = std::move(extras);
    return kept;
}

}  // namespace hm::gltf
