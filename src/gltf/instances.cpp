#include "gltf/instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace hm::gltf {
namespace {

std::uint64_t copy_bytes(const Mesh& mesh) {
    std::uint64_t bytes = sizeof(Mesh);
    for (const Primitive& p : mesh.primitives)
        bytes += sizeof p + p.vertices.size() * sizeof(Vertex) +
                 p.extras.size() * sizeof(VertexExtra) + p.triangles.size() * sizeof(uvec3);
    return bytes;
}

std::vector<bool> nodes_with_animated_weights(const Scene& scene) {
    std::vector<bool> animated(scene.nodes.size(), false);
    for (const Animation& animation : scene.animations)
        for (const Channel& channel : animation.channels)
            if (channel.property == AnimatedProperty::weights) animated[channel.node] = true;
    return animated;
}

}  // namespace

bool is_deformable(const Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                       [](const Primitive& p) { return p.deformation != nullptr; });
}

Result<void> separate_posed_meshes(Source& source, Scene& scene) {
    const std::vector<bool> animated = nodes_with_animated_weights(scene);
    std::map<std::tuple<int, int, int>, int>
        mesh_of_pose;  // mesh, skin, node if it has its own weights
    std::vector<bool> taken(scene.meshes.size(), false);  // by the first pose
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        Node& node = scene.nodes[i];
        if (node.mesh == kUnset || !is_deformable(scene.meshes[std::size_t(node.mesh)])) continue;
        const std::size_t mesh = std::size_t(node.mesh);
        const bool own_weights = !node.weights.empty() || animated[i];
        const auto [known, is_new] = mesh_of_pose.try_emplace(
            {node.mesh, node.skin, own_weights ? static_cast<int>(i) : kUnset}, node.mesh);
        if (is_new && taken[mesh]) {
            const std::uint64_t bytes = copy_bytes(scene.meshes[mesh]);
            if (bytes > source.budget.kept_bytes)
                return fail(ErrorKind::invalid, source.file, fmt::format("/meshes/{}", mesh),
                            "its posed copies exceed the memory limit (memory-limit)");
            source.budget.kept_bytes -= bytes;
            known->second = static_cast<int>(scene.meshes.size());
            scene.meshes.push_back(Mesh(scene.meshes[mesh]));
        }
        taken[mesh] = true;
        node.mesh = known->second;
    }
    return {};
}

}  // namespace hm::gltf
