#include <cmath>

#include "base/check.h"
#include "scene/flatten_parts.h"
#include "scene/material_parameters.h"

namespace hm {
namespace {

bool all_finite(const glm::dmat4& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(float(m[c][r]))) return false;
    return true;
}

void grow(Bounds& bounds, vec3 p) {
    bounds.low = min(bounds.low, p);
    bounds.high = max(bounds.high, p);
}

std::vector<Bounds> mesh_bounds(const Scene& scene) {
    std::vector<Bounds> bounds(scene.meshes.size());
    for (std::size_t m = 0; m < scene.meshes.size(); ++m)
        for (const Primitive& primitive : scene.meshes[m].primitives)
            for (const Vertex& v : primitive.vertices)
                grow(bounds[m], v.position);
    return bounds;
}

// Grows by the bounding box of the transformed box, which is conservative.
void grow_by_instance(Bounds& bounds, const Bounds& mesh, const mat4x3& object_to_world) {
    if (mesh.empty()) return;
    for (int i = 0; i < 8; ++i)
        grow(bounds, object_to_world * vec4((i & 1) != 0 ? mesh.high.x : mesh.low.x,
                                            (i & 2) != 0 ? mesh.high.y : mesh.low.y,
                                            (i & 4) != 0 ? mesh.high.z : mesh.low.z, 1));
}

void add_instance(FlatScene& flat, const Scene& scene, InstanceOrigin origin,
                  const glm::dmat4& exact, const Bounds& local_bounds, Diagnostics& diagnostics) {
    const Node& node = scene.nodes[origin.node];
    // The inverse is that of the rounded matrix, which the renderer reads.
    const glm::mat4 placed(exact);
    const glm::dmat4 to_world(placed);
    const double determinant = glm::determinant(glm::dmat3(to_world));
    const glm::dmat4 to_object = glm::inverse(to_world);
    if (determinant == 0.0 || !all_finite(to_object)) {
        diagnostics.warn(scene.file, pointer_of(node),
                         node.instances.empty() ? "a node has scale zero; its mesh is not rendered"
                                                : "an instance has scale zero; it is not rendered");
        return;
    }
    InstanceData instance{};
    instance.object_to_world = mat4x3(placed);
    instance.world_to_object = mat4x3(to_object);
    instance.mesh = std::uint32_t(node.mesh);
    instance.first_geometry = flat.mesh_first_geometry[instance.mesh];
    instance.flags = determinant < 0.0 || node.skin_mirrors ? kInstanceFlipped : 0u;
    grow_by_instance(flat.bounds, local_bounds, instance.object_to_world);
    flat.instances.push_back(instance);
    flat.instance_origins.push_back(origin);
}

// kGeometryNormalMapped and kGeometryHasTangents, as the material needs them. Anisotropy that an
// animation raised from 0 may find no tangents; then its direction is any.
std::uint32_t tangent_flags(const Scene& scene, const Primitive& p, const std::string& mesh) {
    const Material& material = scene.materials[std::size_t(p.material)];
    const TextureSlot* slot = tangent_texture(material);
    if (slot == nullptr || (slot == &material.anisotropy_texture && !p.has_tangents)) return 0;
    HM_CHECK(p.has_tangents, "mesh \"{}\": prepare_tangents was not called", mesh);
    const bool mapped = material.normal_texture.image != kUnset;
    return kGeometryHasTangents | (mapped ? kGeometryNormalMapped : 0u);
}

}  // namespace

void flatten_geometries(const Scene& scene, FlatScene& flat) {
    for (const Mesh& mesh : scene.meshes) {
        flat.mesh_first_geometry.push_back(std::uint32_t(flat.geometries.size()));
        for (const Primitive& p : mesh.primitives) {
            GeometryData g{};
            g.material = p.material == kUnset ? std::uint32_t(flat.materials.size()) - 1
                                              : std::uint32_t(p.material);
            if (p.has_normals) g.flags |= kGeometryHasNormals;
            if (!p.extras.empty()) g.flags |= kGeometryHasExtras;
            if (p.material != kUnset) g.flags |= tangent_flags(scene, p, mesh.name);
            g.emitter_offset = kNone;
            g.triangle_count = std::uint32_t(p.triangles.size());
            flat.geometries.push_back(g);
            flat.geometry_views.push_back(
                {p.vertices.data(), p.extras.empty() ? nullptr : p.extras.data(),
                 p.triangles.data(), std::uint32_t(p.vertices.size()), g.triangle_count});
        }
    }
    flat.mesh_first_geometry.push_back(std::uint32_t(flat.geometries.size()));
}

void flatten_instances(const Scene& scene, const std::vector<glm::dmat4>& world, FlatScene& flat,
                       Diagnostics& diagnostics) {
    const std::vector<Bounds> local_bounds = mesh_bounds(scene);
    const std::vector<bool> visible = visible_nodes(scene);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (node.mesh == kUnset || !visible[i]) continue;
        const Bounds& bounds = local_bounds[std::size_t(node.mesh)];
        const glm::dmat4 placed = node.skin == kUnset ? world[i] : glm::dmat4(1);
        const auto number = std::uint32_t(i);
        if (node.instances.empty())
            add_instance(flat, scene, {number, 0}, placed, bounds, diagnostics);
        for (std::uint32_t copy = 0; copy < node.instances.size(); ++copy)
            add_instance(flat, scene, {number, copy}, combine(scene, placed, node.instances[copy]),
                         bounds, diagnostics);
    }
}

}  // namespace hm
