#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/alias_table.h"
#include "scene/flatten_parts.h"
#include "shading/math.h"

namespace hm {
namespace {

LightData light_data(const Light& light, float scale, const glm::mat4& world) {
    LightData d{};
    d.kind = light.kind;
    d.position = vec3(world[3]);
    vec3 axis = -vec3(world[2]);
    d.direction = has_direction(world) ? normalize(axis) : vec3(0, 0, -1);
    d.color = light.color * (light.intensity * scale);
    d.range = light.range;
    float cos_outer = std::cos(light.outer_cone);
    d.spot_scale = 1.0f / std::max(0.001f, std::cos(light.inner_cone) - cos_outer);
    d.spot_offset = -cos_outer * d.spot_scale;
    return d;
}

}  // namespace

void warn_of_lost_directions(const Scene& scene, const std::vector<glm::dmat4>& world,
                             Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const bool aimed_light =
            node.light != kUnset && scene.lights[std::size_t(node.light)].kind != kLightPoint;
        if ((node.camera == kUnset && !aimed_light) || has_direction(glm::mat4(world[i]))) continue;
        diagnostics.warn(scene.file, pointer_of(node),
                         "a camera or light has scale zero; it points along the world's -z");
    }
}

void flatten_lights(const Scene& scene, const std::vector<glm::dmat4>& world, float scale,
                    FlatScene& flat) {
    constexpr float pi = std::numbers::pi_v<float>;
    const float radius = float(scene_radius(flat.bounds));
    const float disk = pi * radius * radius;
    const std::vector<bool> visible = visible_nodes(scene);
    std::vector<float> powers;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].light == kUnset || !visible[i]) continue;
        const Light& light = scene.lights[std::size_t(scene.nodes[i].light)];
        const LightData d = light_data(light, scale, glm::mat4(world[i]));
        const float cos_outer = std::cos(light.outer_cone);
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

}  // namespace hm
