#include "scene/scene.h"

#include <fmt/format.h>

namespace hm {

std::string pointer_of(const Node& node) {
    return node.index == kUnset ? "" : fmt::format("/nodes/{}", node.index);
}

std::vector<bool> visible_nodes(const Scene& scene) {
    std::vector<bool> visible;
    visible.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes)
        visible.push_back(node.visible &&
                          (node.parent == kUnset || visible[std::size_t(node.parent)]));
    return visible;
}

glm::dmat4 combine(const Scene& scene, const glm::dmat4& outer, const glm::dmat4& inner) {
    if (scene.double_precision) return outer * inner;
    return glm::mat4(outer) * glm::mat4(inner);
}

std::vector<glm::dmat4> world_transforms(const Scene& scene) {
    std::vector<glm::dmat4> world;
    world.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes)
        world.push_back(node.parent == kUnset
                            ? node.local
                            : combine(scene, world[std::size_t(node.parent)], node.local));
    for (glm::dmat4& matrix : world)
        matrix[3] -= glm::dvec4(scene.origin, 0);
    return world;
}

}  // namespace hm
