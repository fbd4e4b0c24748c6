#include "scene/flatten.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "scene/alias_table.h"
#include "scene/emitters.h"
#include "shading/math.h"

namespace hm {
namespace {

constexpr std::uint8_t kWhiteTexel[4] = {255, 255, 255, 255};

std::uint32_t add_texture_use(FlatScene& flat, const TextureSlot& slot) {
    if (slot.image == kUnset) return 0;
    flat.texture_uses.push_back({std::uint32_t(slot.image) + 1, slot.wrap_u, slot.wrap_v,
                                 slot.filter_mode, slot.uv_set, slot.uv_row_u, slot.uv_row_v});
    return std::uint32_t(flat.texture_uses.size()) - 1;
}

void add_material(FlatScene& flat, const Material& m) {
    MaterialData d{};
    d.base_color_factor = m.base_color;
    d.emissive_factor = m.emissive;
    d.specular_weight = m.specular_weight;
    d.metallic_factor = m.metallic;
    d.roughness_factor = m.roughness;
    d.normal_scale = m.normal_scale;
    d.occlusion_strength = m.occlusion_strength;
    d.base_color_texture = add_texture_use(flat, m.base_color_texture);
    d.emissive_texture = add_texture_use(flat, m.emissive_texture);
    d.metallic_roughness_texture = add_texture_use(flat, m.metallic_roughness_texture);
    d.normal_texture = add_texture_use(flat, m.normal_texture);
    d.occlusion_texture = add_texture_use(flat, m.occlusion_texture);
    d.alpha_cutoff = m.alpha_cutoff;
    d.alpha_mode = m.alpha_mode;
    d.flags = (m.double_sided ? kMaterialDoubleSided : 0u) | (m.unlit ? kMaterialUnlit : 0u);
    flat.materials.push_back(d);
}

void add_materials(FlatScene& flat, const Scene& scene) {
    flat.images.push_back({kWhiteTexel, 1, 1, std::uint32_t(PixelFormat::rgba8)});
    for (const Image& image : scene.images)
        flat.images.push_back(
            {image.pixels.data(), image.width, image.height, std::uint32_t(image.format)});
    flat.texture_uses.push_back({0, 0, 0, 0, 0, vec3(1, 0, 0), vec3(0, 1, 0)});
    for (const Material& m : scene.materials)
        add_material(flat, m);
    add_material(flat, Material{});
}

void add_geometries(FlatScene& flat, const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) {
        flat.mesh_first_geometry.push_back(std::uint32_t(flat.geometries.size()));
        for (const Primitive& p : mesh.primitives) {
            GeometryData g{};
            g.material = p.material == kUnset ? std::uint32_t(flat.materials.size()) - 1
                                              : std::uint32_t(p.material);
            if (p.has_normals) g.flags |= kGeometryHasNormals;
            if (!p.extras.empty()) g.flags |= kGeometryHasExtras;
            if (flat.materials[g.material].normal_texture != 0) {
                HM_CHECK(p.has_tangents, "mesh \"{}\": prepare_tangents was not called", mesh.name);
                g.flags |= kGeometryNormalMapped;
            }
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

// The box around the transformed box: never smaller than the instance itself.
void grow_by_instance(Bounds& bounds, const Bounds& mesh, const mat4x3& object_to_world) {
    if (mesh.empty()) return;
    for (int i = 0; i < 8; ++i)
        grow(bounds, object_to_world * vec4((i & 1) != 0 ? mesh.high.x : mesh.low.x,
                                            (i & 2) != 0 ? mesh.high.y : mesh.low.y,
                                            (i & 4) != 0 ? mesh.high.z : mesh.low.z, 1));
}

void add_instance(FlatScene& flat, const Scene& scene, InstanceOrigin origin,
                  const glm::mat4& placed, const Bounds& local_bounds, Diagnostics& diagnostics) {
    const Node& node = scene.nodes[origin.node];
    const glm::dmat4 to_world(placed);
    const double determinant = glm::determinant(glm::dmat3(to_world));
    const glm::dmat4 to_object = glm::inverse(to_world);
    if (determinant == 0.0 || !all_finite(to_object)) {
        diagnostics.warn(scene.file, pointer_of(node),
                         node.instances.empty()
                             ? "a node is scaled to nothing; its mesh is not drawn"
                             : "an instance is scaled to nothing; it is not drawn");
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

void add_instances(FlatScene& flat, const Scene& scene, const std::vector<glm::mat4>& world,
                   Diagnostics& diagnostics) {
    const std::vector<Bounds> local_bounds = mesh_bounds(scene);
    const std::vector<bool> visible = visible_nodes(scene);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (node.mesh == kUnset || !visible[i]) continue;
        const Bounds& bounds = local_bounds[std::size_t(node.mesh)];
        const glm::mat4 placed = node.skin == kUnset ? world[i] : glm::mat4(1);
        const auto number = std::uint32_t(i);
        if (node.instances.empty())
            add_instance(flat, scene, {number, 0}, placed, bounds, diagnostics);
        for (std::uint32_t copy = 0; copy < node.instances.size(); ++copy)
            add_instance(flat, scene, {number, copy}, placed * node.instances[copy], bounds,
                         diagnostics);
    }
}

// Of cameras and of lamps that shine along an axis.
void warn_of_lost_directions(const Scene& scene, const std::vector<glm::mat4>& world,
                             Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const bool aimed_light =
            node.light != kUnset && scene.lights[std::size_t(node.light)].kind != kLightPoint;
        if ((node.camera == kUnset && !aimed_light) || has_direction(world[i])) continue;
        diagnostics.warn(scene.file, pointer_of(node),
                         "a camera or lamp is scaled to nothing; it looks along the world's -z");
    }
}

void add_lights(FlatScene& flat, const Scene& scene, const std::vector<glm::mat4>& world) {
    constexpr float pi = std::numbers::pi_v<float>;
    const float radius = std::clamp(flat.bounds.radius(), 1e-3f, 1e15f);
    const float disk = pi * radius * radius;
    const std::vector<bool> visible = visible_nodes(scene);
    std::vector<float> powers;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].light == kUnset || !visible[i]) continue;
        const Light& light = scene.lights[std::size_t(scene.nodes[i].light)];
        LightData d{};
        d.kind = light.kind;
        d.position = vec3(world[i][3]);
        vec3 axis = -vec3(world[i][2]);
        d.direction = has_direction(world[i]) ? normalize(axis) : vec3(0, 0, -1);
        d.color = light.color * light.intensity;
        d.range = light.range;
        float cos_outer = std::cos(light.outer_cone);
        d.spot_scale = 1.0f / std::max(0.001f, std::cos(light.inner_cone) - cos_outer);
        d.spot_offset = -cos_outer * d.spot_scale;
        if (!(luminance(d.color) > 0)) continue;
        float extent = light.kind == kLightDirectional ? disk
                       : light.kind == kLightPoint     ? 4 * pi
                                                       : 2 * pi * (1 - cos_outer);
        powers.push_back(std::min(luminance(d.color) * extent, kMaxLightPower));
        flat.punctual_power += double(powers.back());
        flat.lights.push_back(d);
        flat.light_nodes.push_back(std::uint32_t(i));
    }
    flat.light_alias = build_alias_table(powers);
}

}  // namespace

FlatScene flatten(const Scene& scene, EnvironmentMap environment, LightChoice choice,
                  Diagnostics& diagnostics) {
    FlatScene flat;
    flat.environment = environment.data;
    flat.mean_radiance = environment.mean_radiance;
    flat.environment_texels = std::move(environment.texels);
    flat.environment_alias = std::move(environment.alias);
    std::vector<glm::mat4> world = world_transforms(scene);
    add_materials(flat, scene);
    add_geometries(flat, scene);
    add_instances(flat, scene, world, diagnostics);
    warn_of_lost_directions(scene, world, diagnostics);
    if (choice.punctual) add_lights(flat, scene, world);
    if (choice.emitters) add_emitters(flat);
    const double radius = std::clamp(double(flat.bounds.radius()), 1e-3, 1e15);
    constexpr double pi = std::numbers::pi;
    if (environment.data.intensity > 0)
        flat.environment_power = double(environment.mean_radiance) * 4 * pi * pi * radius * radius;
    return flat;
}

EnvironmentMap take_environment(FlatScene& scene) {
    return {scene.environment, std::move(scene.environment_texels),
            std::move(scene.environment_alias), scene.mean_radiance};
}

}  // namespace hm
