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

std::vector<glm::mat4> world_transforms(const Scene& scene) {
    std::vector<glm::mat4> world;
    world.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes)
        world.push_back(node.parent == kUnset ? node.local
                                              : world[std::size_t(node.parent)] * node.local);
    return world;
}

}  // namespace hm
