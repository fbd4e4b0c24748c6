#include "scene/origin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hm {
namespace {

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    bool empty() const { return !(low.x <= high.x); }
    void grow(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

// Of the vertices before posing, which a skin's matrices transform.
Box rest_box(const Mesh& mesh) {
    Box box;
    for (const Primitive& p : mesh.primitives) {
        const std::vector<Vertex>& vertices = p.deformation ? p.deformation->rest : p.vertices;
        if (vertices.empty()) continue;
        vec3 low = vertices[0].position, high = low;
        for (const Vertex& v : vertices) {
            low = min(low, v.position);
            high = max(high, v.position);
        }
        box.grow(low);
        box.grow(high);
    }
    return box;
}

void grow_by_transformed(Box& box, const Box& part, const glm::dmat4& to_world) {
    for (int i = 0; i < 8; ++i)
        box.grow(glm::dvec3(to_world * glm::dvec4((i & 1) != 0 ? part.high.x : part.low.x,
                                                  (i & 2) != 0 ? part.high.y : part.low.y,
                                                  (i & 4) != 0 ? part.high.z : part.low.z, 1)));
}

// World transforms in the file's own coordinates.
std::vector<glm::dmat4> file_transforms(const Scene& scene) {
    std::vector<glm::dmat4> world;
    world.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes)
        world.push_back(node.parent == kUnset ? node.local
                                              : world[std::size_t(node.parent)] * node.local);
    return world;
}

// Nodes whose transforms decide where a mesh is: those of meshes and their ancestors.
std::vector<bool> nodes_of_meshes(const Scene& scene) {
    std::vector<bool> counts(scene.nodes.size(), false);
    for (std::size_t i = scene.nodes.size(); i-- > 0;) {
        const Node& node = scene.nodes[i];
        if (node.mesh != kUnset) counts[i] = true;
        if (counts[i] && node.parent != kUnset) counts[std::size_t(node.parent)] = true;
    }
    return counts;
}

// A skinned mesh counts where each of its joints would move all of it.
Box scene_box(const Scene& scene, const std::vector<glm::dmat4>& world) {
    std::vector<Box> meshes;
    for (const Mesh& mesh : scene.meshes)
        meshes.push_back(rest_box(mesh));
    Box box;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (node.mesh == kUnset || meshes[std::size_t(node.mesh)].empty()) continue;
        const Box& mesh = meshes[std::size_t(node.mesh)];
        if (node.skin != kUnset) {
            const Skin& skin = scene.skins[std::size_t(node.skin)];
            for (std::size_t j = 0; j < skin.joints.size(); ++j)
                grow_by_transformed(
                    box, mesh,
                    world[std::size_t(skin.joints[j])] * glm::dmat4(skin.inverse_bind[j]));
        } else if (node.instances.empty()) {
            grow_by_transformed(box, mesh, world[i]);
        }
        for (const glm::mat4& instance : node.instances)
            grow_by_transformed(box, mesh, world[i] * glm::dmat4(instance));
    }
    return box;
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// The largest translation, local or accumulated, of nodes with meshes and their ancestors. It may
// exceed the final positions, if one node moves a mesh away and another one back.
double largest_translation(const Scene& scene, const std::vector<glm::dmat4>& world) {
    const std::vector<bool> counts = nodes_of_meshes(scene);
    double most = 0;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        if (counts[i])
            most = std::max({most, largest(glm::dvec3(world[i][3])),
                             largest(glm::dvec3(scene.nodes[i].local[3]))});
    return most;
}

}  // namespace

void set_local(const Scene& scene, Node& node, const Transform& transform) {
    if (scene.double_precision)
        node.local = to_matrix(transform);
    else
        node.local = glm::mat4(to_matrix(round_to_floats(transform)));
}

void set_origin(Scene& scene) {
    const std::vector<glm::dmat4> world = file_transforms(scene);
    const Box box = scene_box(scene, world);
    const glm::dvec3 middle = box.empty() ? glm::dvec3(0) : 0.5 * (box.low + box.high);
    const double radius = box.empty() ? 0 : 0.5 * glm::length(box.high - box.low);
    const double far = kFarInRadii * radius;
    const bool has_size = radius > 0 && std::isfinite(radius);
    scene.double_precision =
        has_size && std::max(largest(middle), largest_translation(scene, world)) > far;
    scene.origin = glm::dvec3(0);
    if (has_size && largest(middle) > far) {
        const double grid = std::exp2(std::floor(std::log2(radius)));
        scene.origin = glm::round(middle / grid) * grid;
    }
    for (Node& node : scene.nodes) {
        if (node.rest)
            set_local(scene, node, *node.rest);
        else if (!scene.double_precision)
            node.local = glm::mat4(node.local);
    }
}

}  // namespace hm
