#include "scene/surface_names.h"

#include <fmt/format.h>

namespace hm {
namespace {

std::string node_name(const Scene& scene, std::size_t i) {
    const Node& node = scene.nodes[i];
    if (!node.name.empty()) return node.name;
    if (node.mesh != kUnset && !scene.meshes[std::size_t(node.mesh)].name.empty())
        return scene.meshes[std::size_t(node.mesh)].name;
    return fmt::format("node {}", i);
}

std::string material_name(const Scene& scene, std::size_t i) {
    if (i >= scene.materials.size()) return "default";
    const std::string& name = scene.materials[i].name;
    return name.empty() ? fmt::format("material {}", i) : name;
}

std::size_t root_of(const Scene& scene, std::size_t node) {
    while (scene.nodes[node].parent != kUnset)
        node = std::size_t(scene.nodes[node].parent);
    return node;
}

}  // namespace

std::vector<std::uint32_t> first_surfaces(const FlatScene& flat) {
    std::vector<std::uint32_t> firsts = {0};
    for (const InstanceData& instance : flat.instances)
        firsts.push_back(firsts.back() + flat.mesh_first_geometry[instance.mesh + 1] -
                         flat.mesh_first_geometry[instance.mesh]);
    return firsts;
}

SurfaceNames name_surfaces(const Scene& scene, const FlatScene& flat) {
    SurfaceNames names;
    for (std::size_t i = 0; i < flat.instances.size(); ++i) {
        const InstanceOrigin origin = flat.instance_origins[i];
        std::string object = node_name(scene, origin.node);
        if (!scene.nodes[origin.node].instances.empty()) object += fmt::format("[{}]", origin.copy);
        const std::string asset = node_name(scene, root_of(scene, origin.node));
        const std::uint32_t mesh = flat.instances[i].mesh;
        for (std::uint32_t g = flat.mesh_first_geometry[mesh];
             g < flat.mesh_first_geometry[mesh + 1]; ++g) {
            names.objects.push_back(object);
            names.materials.push_back(material_name(scene, flat.geometries[g].material));
            names.assets.push_back(asset);
        }
    }
    return names;
}

}  // namespace hm
