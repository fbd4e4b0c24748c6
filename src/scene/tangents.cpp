#include "scene/tangents.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "scene/index_table.h"
#include "scene/material_parameters.h"
#include "scene/tangent_space.h"

namespace hm {
namespace {

// Where the texture is looked up. Its transform may rotate or mirror, and the relief with it.
vec2 uv_of(const Primitive& p, std::uint32_t vertex, const TextureSlot& slot) {
    vec2 uv = p.vertices[vertex].uv0;
    if (slot.uv_set != 0) uv = p.extras.empty() ? vec2(0) : p.extras[vertex].uv1;
    return vec2(dot(slot.uv_row_u, vec3(uv, 1)), dot(slot.uv_row_v, vec3(uv, 1)));
}

vec3 face_normal(const Primitive& p, uvec3 t) {
    const glm::dvec3 a(p.vertices[t.x].position);
    const glm::dvec3 n = glm::cross(glm::dvec3(p.vertices[t.y].position) - a,
                                    glm::dvec3(p.vertices[t.z].position) - a);
    const double size = glm::length(n);
    return size > 0 ? vec3(n / size) : vec3(0);
}

std::vector<vec4> tangents_with_normals(const Primitive& p, const TextureSlot& slot) {
    std::vector<SurfacePoint> points;
    points.reserve(p.vertices.size());
    for (std::uint32_t v = 0; v < p.vertices.size(); ++v)
        points.push_back({p.vertices[v].position, p.vertices[v].normal, uv_of(p, v, slot)});
    return corner_tangents(points, p.triangles);
}

// Each corner is a separate vertex with its face normal.
std::vector<vec4> tangents_of_flat_faces(const Primitive& p, const TextureSlot& slot) {
    std::vector<SurfacePoint> points;
    std::vector<uvec3> triangles;
    points.reserve(3 * p.triangles.size());
    triangles.reserve(p.triangles.size());
    for (const uvec3& t : p.triangles) {
        const auto first = static_cast<std::uint32_t>(points.size());
        const vec3 normal = face_normal(p, t);
        for (const std::uint32_t v : {t.x, t.y, t.z})
            points.push_back({p.vertices[v].position, normal, uv_of(p, v, slot)});
        triangles.emplace_back(first, first + 1, first + 2);
    }
    return corner_tangents(points, triangles);
}

using Bits = std::array<std::uint32_t, 5>;

Bits bits_of(std::uint32_t vertex, vec4 t) {
    return {vertex, std::bit_cast<std::uint32_t>(t.x), std::bit_cast<std::uint32_t>(t.y),
            std::bit_cast<std::uint32_t>(t.z), std::bit_cast<std::uint32_t>(t.w)};
}

// Assigns the tangents. The first corner of a vertex keeps it; a corner with a different tangent
// gets a copy of the vertex, shared by all corners with that vertex and tangent.
std::vector<std::uint32_t> split_vertices(Primitive& p, const std::vector<vec4>& corners) {
    std::vector<std::uint32_t> new_to_old(p.vertices.size());
    std::iota(new_to_old.begin(), new_to_old.end(), 0u);
    std::vector<bool> taken(p.vertices.size(), false);
    IndexTable copies(0);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        std::uint32_t& vertex = p.triangles[c / 3][int(c % 3)];
        if (!taken[vertex]) {
            taken[vertex] = true;
            p.vertices[vertex].tangent = corners[c];
        }
        const Bits bits = bits_of(vertex, corners[c]);
        if (bits_of(vertex, p.vertices[vertex].tangent) == bits) continue;
        const auto added = static_cast<std::uint32_t>(p.vertices.size());
        const std::uint32_t copy = copies.find_or_add(hash_words(bits), added, [&](auto other) {
            return bits_of(new_to_old[other], p.vertices[other].tangent) == bits;
        });
        if (copy == added) {
            new_to_old.push_back(vertex);
            p.vertices.push_back(p.vertices[vertex]);
            p.vertices.back().tangent = corners[c];
            if (!p.extras.empty()) p.extras.push_back(p.extras[vertex]);
        }
        vertex = copy;
    }
    return new_to_old;
}

template <class T>
void copy_deltas(std::vector<Delta<T>>& deltas, std::span<const std::uint32_t> copied,
                 std::uint32_t first_copy) {
    for (std::size_t i = 0; i < copied.size(); ++i) {
        const auto at = std::lower_bound(
            deltas.begin(), deltas.end(), copied[i],
            [](const Delta<T>& d, std::uint32_t vertex) { return d.vertex < vertex; });
        if (at == deltas.end() || at->vertex != copied[i]) continue;
        const T value = at->value;
        deltas.push_back({first_copy + std::uint32_t(i), value});
    }
}

// Splits the deformation like the primitive's vertices, which are in the rest pose.
std::shared_ptr<const Deformation> split_deformation(const Primitive& p,
                                                     const std::vector<std::uint32_t>& new_to_old) {
    auto d = std::make_shared<Deformation>(*p.deformation);
    const auto first_copy = static_cast<std::uint32_t>(d->rest.size());
    const auto copied = std::span(new_to_old).subspan(first_copy);
    d->rest = p.vertices;
    d->rest_extras = p.extras;
    for (MorphTarget& target : d->targets) {
        copy_deltas(target.positions, copied, first_copy);
        copy_deltas(target.normals, copied, first_copy);
        copy_deltas(target.tangents, copied, first_copy);
        copy_deltas(target.uv0, copied, first_copy);
        copy_deltas(target.uv1, copied, first_copy);
        copy_deltas(target.colors, copied, first_copy);
    }
    for (const std::uint32_t vertex : copied)
        for (std::uint32_t i = 0; i < d->influences; ++i) {
            const std::size_t from = std::size_t(vertex) * d->influences + i;
            d->joints.push_back(std::uint16_t(d->joints[from]));
            d->weights.push_back(float(d->weights[from]));
        }
    return d;
}

}  // namespace

std::vector<std::uint32_t> generate_tangents(Primitive& primitive, const TextureSlot& slot) {
    const std::vector<vec4> corners = primitive.has_normals
                                          ? tangents_with_normals(primitive, slot)
                                          : tangents_of_flat_faces(primitive, slot);
    primitive.has_tangents = true;
    return split_vertices(primitive, corners);
}

void prepare_tangents(Scene& scene) {
    struct Work {
        Primitive* primitive;
        const TextureSlot* slot;
    };
    std::vector<Work> work;
    for (Mesh& mesh : scene.meshes)
        for (Primitive& p : mesh.primitives) {
            if (p.material == kUnset || p.has_tangents) continue;
            const TextureSlot* slot = tangent_texture(scene.materials[std::size_t(p.material)]);
            if (slot != nullptr) work.push_back({&p, slot});
        }
    tbb::parallel_for(std::size_t(0), work.size(), [&](std::size_t i) {
        Primitive& p = *work[i].primitive;
        const std::vector<std::uint32_t> new_to_old = generate_tangents(p, *work[i].slot);
        if (p.deformation) p.deformation = split_deformation(p, new_to_old);
    });
}

}  // namespace hm
