// Triangle meshes for the demo scenes: boxes, surfaces of revolution, tubes, grids.
// Tangents follow glTF: along growing u, with the bitangent cross(normal, tangent) * w pointing
// towards the picture's top (falling v).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace hm {

struct TriangleMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;  // empty, or one per vertex
    std::vector<glm::vec2> uvs;       // empty, or one per vertex
    std::vector<std::uint32_t> indices;
};

// Appends `part` moved by an affine transform without shear. Both have the same attributes, unless
// `mesh` is empty.
void append(TriangleMesh& mesh, const TriangleMesh& part, const glm::mat4& transform);

// A vertex of a parametric surface, without normal and tangent.
struct SurfacePoint {
    glm::vec3 position;
    glm::vec2 uv;
};

// (columns + 1) x (rows + 1) vertices of surface(s, t), s and t from 0 to 1. Normals and tangents
// are finite differences of the surface: the normal is along cross(d/ds, d/dt), so with s to the
// right and t upwards the surface faces the viewer.
TriangleMesh make_surface(int columns, int rows,
                          const std::function<SurfacePoint(float s, float t)>& surface);

// The flat quad corner, corner + u, corner + u + v, corner + v; faces cross(u, v). Texture
// coordinates run from 0 to `repeats`, with v falling along the edge v.
TriangleMesh make_quad(glm::vec3 corner, glm::vec3 u, glm::vec3 v, glm::vec2 repeats = {1, 1});

// A box around the origin with edges rounded by `radius`, textured by its faces at `uv_per_metre`.
TriangleMesh make_rounded_box(glm::vec3 half_extents, float radius, float uv_per_metre);

// Revolves a profile of (radius, height) points around the y axis. With y up and the radius to the
// right, the outside is on the right of the profile's direction (upwards, for an outer wall). A
// repeated point is a crease. u runs `u_repeats` times around, v falls along the profile by arc
// length / `v_length`.
TriangleMesh make_revolved(std::span<const glm::vec2> profile, int segments, float u_repeats,
                           float v_length);

// Catmull-Rom points through `knots`, `per_span` to each span; a repeated knot is a crease.
std::vector<glm::vec2> smooth_profile(std::span<const glm::vec2> knots, int per_span);

// A unit sphere with its poles on y; u covers 0 to 1 once around.
TriangleMesh make_sphere(int segments, int rings);

// A round tube along a polyline.
TriangleMesh make_tube(std::span<const glm::vec3> path, float radius, int segments);

}  // namespace hm
