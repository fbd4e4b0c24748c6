#include "scene/motion.h"

#include "base/check.h"

namespace hm {

PoseRecord record_pose(const Scene& scene) {
    PoseRecord record{world_transforms(scene), {}};
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) {
            std::vector<vec3>& positions = record.positions.emplace_back();
            if (!primitive.deformation) continue;
            positions.reserve(primitive.vertices.size());
            for (const Vertex& vertex : primitive.vertices)
                positions.push_back(vertex.position);
        }
    return record;
}

void set_next_pose(FlatScene& flat, const Scene& scene, const PoseRecord& next) {
    HM_CHECK(
        next.world.size() == scene.nodes.size() && next.positions.size() == flat.geometries.size(),
        "{} nodes and {} primitives, {} geometries", next.world.size(), next.positions.size(),
        flat.geometries.size());
    flat.aovs.next_positions = next.positions;
    flat.aovs.next_transforms.clear();
    for (const InstanceOrigin& origin : flat.instance_origins) {
        const Node& node = scene.nodes[origin.node];
        glm::dmat4 placed = node.skin == kUnset ? next.world[origin.node] : glm::dmat4(1);
        if (!node.instances.empty()) placed = combine(scene, placed, node.instances[origin.copy]);
        flat.aovs.next_transforms.push_back(mat4x3(placed));
    }
}

}  // namespace hm
