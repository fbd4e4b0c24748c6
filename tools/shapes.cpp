#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hm {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

void add_vertex(TriangleMesh& mesh, glm::vec3 position, glm::vec3 normal, glm::vec4 tangent,
                glm::vec2 uv) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.tangents.push_back(tangent);
    mesh.uvs.push_back(uv);
}

// Two triangles for each cell of a (columns + 1) wide grid of vertices that starts at `first`.
// Triangles that degenerate at a pole are omitted.
void add_grid_triangles(TriangleMesh& mesh, std::uint32_t first, int columns, int rows) {
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::vec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
        if (p == q || q == r || r == p) return;
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    const auto stride = std::uint32_t(columns) + 1;
    for (std::uint32_t y = 0; y < std::uint32_t(rows); ++y)
        for (std::uint32_t x = 0; x < std::uint32_t(columns); ++x) {
            const std::uint32_t a = first + y * stride + x;
            add(a, a + 1, a + stride + 1);
            add(a, a + stride + 1, a + stride);
        }
}

// A unit tangent orthogonal to the normal; its sign makes the bitangent point towards `up`.
glm::vec4 frame_tangent(glm::vec3 normal, glm::vec3 along_u, glm::vec3 up) {
    const glm::vec3 t = glm::normalize(along_u - normal * glm::dot(normal, along_u));
    return glm::vec4(t, glm::dot(glm::cross(normal, t), up) < 0 ? -1.0f : 1.0f);
}

}  // namespace

void append(TriangleMesh& mesh, const TriangleMesh& part, const glm::mat4& transform) {
    const auto first = std::uint32_t(mesh.positions.size());
    const glm::mat3 linear(transform);
    const glm::mat3 for_normals = glm::transpose(glm::inverse(linear));
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
        mesh.positions.push_back(glm::vec3(transform * glm::vec4(part.positions[i], 1)));
        mesh.normals.push_back(glm::normalize(for_normals * part.normals[i]));
    }
    for (const glm::vec4& tangent : part.tangents)
        mesh.tangents.push_back(glm::vec4(glm::normalize(linear * glm::vec3(tangent)), tangent.w));
    mesh.uvs.insert(mesh.uvs.end(), part.uvs.begin(), part.uvs.end());
    for (const std::uint32_t index : part.indices)
        mesh.indices.push_back(first + index);
}

TriangleMesh make_surface(int columns, int rows,
                          const std::function<SurfacePoint(float s, float t)>& surface) {
    TriangleMesh mesh;
    const float step = 1e-3f;
    for (int y = 0; y <= rows; ++y)
        for (int x = 0; x <= columns; ++x) {
            const float s = float(x) / float(columns), t = float(y) / float(rows);
            const SurfacePoint point = surface(s, t);
            const glm::vec3 ds = surface(s + step, t).position - surface(s - step, t).position;
            const glm::vec3 dt = surface(s, t + step).position - surface(s, t - step).position;
            const glm::vec3 normal = glm::normalize(glm::cross(ds, dt));
            add_vertex(mesh, point.position, normal, frame_tangent(normal, ds, dt), point.uv);
        }
    add_grid_triangles(mesh, 0, columns, rows);
    return mesh;
}

TriangleMesh make_quad(glm::vec3 corner, glm::vec3 u, glm::vec3 v, glm::vec2 repeats) {
    TriangleMesh mesh;
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    const glm::vec4 tangent = frame_tangent(normal, u, v);
    add_vertex(mesh, corner, normal, tangent, {0, repeats.y});
    add_vertex(mesh, corner + u, normal, tangent, repeats);
    add_vertex(mesh, corner + u + v, normal, tangent, {repeats.x, 0});
    add_vertex(mesh, corner + v, normal, tangent, {0, 0});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

TriangleMesh make_rounded_box(glm::vec3 half_extents, float radius, float uv_per_metre) {
    TriangleMesh mesh;
    const glm::vec3 core = half_extents - radius;
    const auto stations = [&](int axis) {
        const float h = half_extents[axis], c = core[axis];
        return std::array<float, 6>{-h, -c - 0.45f * radius, -c, c, c + 0.45f * radius, h};
    };
    // Each face is a grid on the cube, projected onto the sphere of `radius` around the core.
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2, u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
        const float side = face % 2 == 0 ? 1.0f : -1.0f;
        const auto us = stations(u_axis), vs = stations(v_axis);
        const auto first = std::uint32_t(mesh.positions.size());
        for (const float v : vs)
            for (const float u : us) {
                glm::vec3 on_cube(0);
                on_cube[axis] = side * half_extents[axis];
                on_cube[u_axis] = side * u;  // mirrored with the side, to keep the winding outward
                on_cube[v_axis] = v;
                const glm::vec3 in_core = glm::clamp(on_cube, -core, core);
                const glm::vec3 normal = glm::normalize(on_cube - in_core);
                glm::vec3 along_u(0), up(0);
                along_u[u_axis] = side;
                up[v_axis] = 1;
                const glm::vec3 position = in_core + radius * normal;
                add_vertex(mesh, position, normal, frame_tangent(normal, along_u, up),
                           {u * uv_per_metre, -v * uv_per_metre});
            }
        add_grid_triangles(mesh, first, 5, 5);
    }
    return mesh;
}

TriangleMesh make_revolved(std::span<const glm::vec2> profile, int segments, float u_repeats,
                           float v_length) {
    TriangleMesh mesh;
    float along = 0;
    std::uint32_t first = 0;
    int rows = -1;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const bool starts = i == 0 || profile[i] == profile[i - 1];
        const bool ends = i + 1 == profile.size() || profile[i] == profile[i + 1];
        if (starts) {
            first = std::uint32_t(mesh.positions.size());
            rows = -1;
        } else {
            along += glm::length(profile[i] - profile[i - 1]);
        }
        const glm::vec2 before = starts ? profile[i] : profile[i - 1];
        const glm::vec2 after = ends ? profile[i] : profile[i + 1];
        const glm::vec2 d = glm::normalize(after - before);
        for (int k = 0; k <= segments; ++k) {
            const float turn = float(k % segments) / float(segments);
            const float c = std::cos(2 * kPi * turn), s = std::sin(2 * kPi * turn);
            const glm::vec3 out(c, 0, -s), around(-s, 0, -c);
            const glm::vec3 normal = out * d.y + glm::vec3(0, -d.x, 0);
            const glm::vec3 up = out * d.x + glm::vec3(0, d.y, 0);
            add_vertex(mesh, out * profile[i].x + glm::vec3(0, profile[i].y, 0), normal,
                       frame_tangent(normal, around, up),
                       {u_repeats * float(k) / float(segments), -along / v_length});
        }
        ++rows;
        if (ends) add_grid_triangles(mesh, first, segments, rows);
    }
    return mesh;
}

std::vector<glm::vec2> smooth_profile(std::span<const glm::vec2> knots, int per_span) {
    std::vector<glm::vec2> points;
    const std::size_t n = knots.size();
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const glm::vec2 p1 = knots[i], p2 = knots[i + 1];
        points.push_back(p1);
        if (p1 == p2) continue;
        // Beyond an end or a crease the curve is extended linearly.
        const glm::vec2 p0 = i > 0 && knots[i - 1] != p1 ? knots[i - 1] : p1 + (p1 - p2);
        const glm::vec2 p3 = i + 2 < n && knots[i + 2] != p2 ? knots[i + 2] : p2 + (p2 - p1);
        for (int k = 1; k < per_span; ++k) {
            const float t = float(k) / float(per_span);
            const glm::vec2 a = 2.0f * p0 - 5.0f * p1 + 4.0f * p2 - p3;
            const glm::vec2 b = 3.0f * (p1 - p2) + p3 - p0;
            const glm::vec2 p = p1 + 0.5f * t * (p2 - p0 + t * (a + t * b));
            points.push_back({std::max(p.x, 0.0f), p.y});
        }
    }
    points.push_back(knots.back());
    return points;
}

TriangleMesh make_sphere(int segments, int rings) {
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= rings; ++i) {
        const float angle = kPi * (float(i) / float(rings) - 0.5f);
        const bool pole = i == 0 || i == rings;
        profile.push_back({pole ? 0.0f : std::cos(angle), std::sin(angle)});
    }
    TriangleMesh mesh = make_revolved(profile, segments, 1, kPi);
    mesh.normals = mesh.positions;  // exact; those of the polyline are averages
    return mesh;
}

TriangleMesh make_tube(std::span<const glm::vec3> path, float radius, int segments) {
    TriangleMesh mesh;
    const std::size_t n = path.size();
    for (std::size_t i = 0; i < n; ++i) {
        const glm::vec3 d = glm::normalize(path[std::min(i + 1, n - 1)] - path[i > 0 ? i - 1 : 0]);
        const glm::vec3 helper = std::abs(d.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
        const glm::vec3 a = glm::normalize(glm::cross(helper, d));
        const glm::vec3 b = glm::cross(d, a);
        for (int k = 0; k <= segments; ++k) {
            const float angle = 2 * kPi * float(k % segments) / float(segments);
            const glm::vec3 normal = std::cos(angle) * a + std::sin(angle) * b;
            const glm::vec3 around = std::cos(angle) * b - std::sin(angle) * a;
            add_vertex(mesh, path[i] + radius * normal, normal, frame_tangent(normal, around, d),
                       {float(k) / float(segments), -float(i)});
        }
    }
    add_grid_triangles(mesh, 0, segments, int(n) - 1);
    return mesh;
}

}  // namespace hm
