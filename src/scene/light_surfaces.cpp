#include "scene/light_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shading/geometry.h"

namespace hm {
namespace {

// Planes whose normals are this close (cosine) are one plane for a light.
constexpr float kSamePlane = 0.9999f;

void grow(Bounds& box, vec3 p) {
    box.low = min(box.low, p);
    box.high = max(box.high, p);
}

bool overlap(const Bounds& a, const Bounds& b) {
    return all(lessThanEqual(a.low, b.high)) && all(lessThanEqual(b.low, a.high));
}

bool is_finite(vec3 p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// A k-d tree of the finite lights: each range of `order_` is split at its middle element, along the
// axis on which it is spread most.
class FiniteLights {
  public:
    explicit FiniteLights(const std::vector<LightData>& lights) : lights_(lights) {
        for (std::uint32_t i = 0; i < lights.size(); ++i)
            if (lights[i].kind != kLightDirectional && is_finite(lights[i].position))
                order_.push_back(i);
        axes_.resize(order_.size());
        split(0, order_.size());
    }

    bool empty() const { return order_.empty(); }

    // Calls visit(light) for those in the box.
    template <class F>
    void visit_in(const Bounds& box, const F& visit) const {
        visit_range(box, visit, 0, order_.size());
    }

  private:
    void split(std::size_t begin, std::size_t end) {
        if (begin == end) return;
        Bounds bounds;
        for (std::size_t k = begin; k < end; ++k)
            grow(bounds, position(k));
        const vec3 spread = bounds.high - bounds.low;
        const std::size_t middle = begin + (end - begin) / 2;
        std::size_t axis = spread.y > spread.x ? 1 : 0;
        if (spread.z > spread[axis]) axis = 2;
        axes_[middle] = std::uint8_t(axis);
        std::nth_element(
            order_.begin() + std::ptrdiff_t(begin), order_.begin() + std::ptrdiff_t(middle),
            order_.begin() + std::ptrdiff_t(end), [&](std::uint32_t a, std::uint32_t b) {
                return lights_[a].position[axis] < lights_[b].position[axis];
            });
        split(begin, middle);
        split(middle + 1, end);
    }

    template <class F>
    void visit_range(const Bounds& box, const F& visit, std::size_t begin, std::size_t end) const {
        while (begin < end) {
            const std::size_t middle = begin + (end - begin) / 2, axis = axes_[middle];
            const vec3 p = position(middle);
            if (overlap(box, {p, p})) visit(order_[middle]);
            if (box.low[axis] <= p[axis]) visit_range(box, visit, begin, middle);
            if (box.high[axis] < p[axis]) return;
            begin = middle + 1;
        }
    }

    vec3 position(std::size_t k) const { return lights_[order_[k]].position; }

    const std::vector<LightData>& lights_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint8_t> axes_;  // of the split at each element
};

struct WorldTriangle {
    glm::dvec3 corners[3];

    Bounds box(float margin) const {
        return {vec3(min(min(corners[0], corners[1]), corners[2])) - vec3(margin),
                vec3(max(max(corners[0], corners[1]), corners[2])) + vec3(margin)};
    }
};

// Whether p is within `error` of the triangle, whose unit normal is n.
bool lies_on(glm::dvec3 p, const WorldTriangle& t, glm::dvec3 n, double error) {
    if (std::abs(dot(p - t.corners[0], n)) > error) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 edge = t.corners[(k + 1) % 3] - t.corners[k];
        if (dot(cross(n, edge), p - t.corners[k]) < -error * length(edge)) return false;
    }
    return true;
}

// How far off its plane along n a light may be by the rounding of its position, of the vertices and
// of the transform: less than hit_error, which allows for the arithmetic of tracing too.
float placement_error(const InstanceData& instance, vec3 p, float extent, vec3 n) {
    const vec3 local = abs(instance.world_to_object * vec4(p, 1));
    const mat4x3& m = instance.object_to_world;
    const vec3 terms = abs(m[0]) * local.x + abs(m[1]) * local.y + abs(m[2]) * local.z + abs(m[3]);
    return kRoundoff * (3 * dot(abs(n), terms) + extent);
}

void put_on_surface(LightData& light, const InstanceData& instance, const WorldTriangle& t) {
    const glm::dvec3 edge1 = t.corners[1] - t.corners[0], edge2 = t.corners[2] - t.corners[0];
    const glm::dvec3 scaled_normal = cross(edge1, edge2);
    const double double_area = length(scaled_normal);
    if (!(double_area > 0)) return;
    const glm::dvec3 exact_normal = scaled_normal / double_area;
    const vec3 n(exact_normal);
    const float extent = triangle_extent(vec3(edge1), vec3(edge2));
    const float placement = placement_error(instance, light.position, extent, n);
    if (!lies_on(glm::dvec3(light.position), t, exact_normal, double(placement))) return;
    if (light.surface_error == 0)
        light.surface_normal = n;
    else if (std::abs(dot(light.surface_normal, n)) < kSamePlane)
        light.surface_normal = vec3(0);
    const float error = hit_error(transform_magnitude(instance, abs(light.position)), extent, n);
    light.surface_error = std::max(light.surface_error, error);
}

// The box of an instance, and the largest error of hits on it.
struct Reach {
    Bounds box;
    float error;
};

Reach reach_of(const InstanceData& instance, const Bounds& mesh) {
    Bounds box;
    for (int i = 0; i < 8; ++i)
        grow(box, instance.object_to_world * vec4((i & 1) != 0 ? mesh.high.x : mesh.low.x,
                                                  (i & 2) != 0 ? mesh.high.y : mesh.low.y,
                                                  (i & 4) != 0 ? mesh.high.z : mesh.low.z, 1));
    const vec3 farthest = max(abs(box.low), abs(box.high));
    const float error = hit_error(transform_magnitude(instance, farthest),
                                  max_component(box.high - box.low), vec3(1));
    return {{box.low - vec3(error), box.high + vec3(error)}, error};
}

std::vector<Bounds> mesh_bounds(const FlatScene& flat) {
    std::vector<Bounds> bounds(flat.mesh_first_geometry.size() - 1);
    for (std::size_t m = 0; m < bounds.size(); ++m)
        for (std::uint32_t g = flat.mesh_first_geometry[m]; g < flat.mesh_first_geometry[m + 1];
             ++g) {
            const GeometryView& view = flat.geometry_views[g];
            for (const Vertex& v : std::span(view.vertices, view.vertex_count))
                grow(bounds[m], v.position);
        }
    return bounds;
}

void visit_triangles(FlatScene& flat, const FiniteLights& lights, const InstanceData& instance,
                     const Reach& reach) {
    Bounds lit;  // of the lights that can be on the instance
    lights.visit_in(reach.box, [&](std::uint32_t i) { grow(lit, flat.lights[i].position); });
    if (lit.empty()) return;
    const glm::dmat4x3 to_world(instance.object_to_world);
    for (std::uint32_t g = instance.first_geometry; g < flat.mesh_first_geometry[instance.mesh + 1];
         ++g) {
        const GeometryView& view = flat.geometry_views[g];
        const auto corner = [&](std::uint32_t vertex) {
            return to_world * glm::dvec4(glm::dvec3(view.vertices[vertex].position), 1);
        };
        for (const uvec3& t : std::span(view.triangles, view.triangle_count)) {
            const WorldTriangle triangle{{corner(t.x), corner(t.y), corner(t.z)}};
            const Bounds box = triangle.box(reach.error);
            if (!overlap(box, lit)) continue;
            lights.visit_in(
                box, [&](std::uint32_t i) { put_on_surface(flat.lights[i], instance, triangle); });
        }
    }
}

}  // namespace

void find_light_surfaces(FlatScene& flat) {
    const FiniteLights lights(flat.lights);
    if (lights.empty()) return;
    const std::vector<Bounds> bounds = mesh_bounds(flat);
    for (const InstanceData& instance : flat.instances)
        if (!bounds[instance.mesh].empty())
            visit_triangles(flat, lights, instance, reach_of(instance, bounds[instance.mesh]));
}

}  // namespace hm
