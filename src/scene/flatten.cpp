#include "scene/flatten.h"

#include <algorithm>
#include <numbers>

#include "scene/emitters.h"
#include "scene/flatten_parts.h"
#include "scene/light_surfaces.h"

namespace hm {

double scene_radius(const Bounds& bounds) {
    return std::clamp(double(bounds.radius()), 1e-3, 1e15);
}

FlatScene flatten(const Scene& scene, EnvironmentMap environment, LightChoice choice,
                  Diagnostics& diagnostics) {
    FlatScene flat;
    flat.environment = environment.data;
    flat.mean_radiance = environment.mean_radiance;
    flat.environment_texels = std::move(environment.texels);
    flat.environment_alias = std::move(environment.alias);
    const std::vector<glm::dmat4> world = world_transforms(scene);
    flatten_materials(scene, flat);
    flatten_geometries(scene, flat);
    flatten_instances(scene, world, flat, diagnostics);
    warn_of_lost_directions(scene, world, diagnostics);
    if (choice.punctual) flatten_lights(scene, world, choice.punctual_scale, flat);
    find_light_surfaces(flat);
    if (choice.emitters) add_emitters(flat);
    if (flat.environment.intensity > 0) {
        // Flux through the scene's bounding disk, seen from every direction.
        const double radius = scene_radius(flat.bounds);
        constexpr double pi = std::numbers::pi;
        flat.environment_power = double(flat.mean_radiance) * 4 * pi * pi * radius * radius;
    }
    return flat;
}

EnvironmentMap take_environment(FlatScene& scene) {
    return {scene.environment, std::move(scene.environment_texels),
            std::move(scene.environment_alias), scene.mean_radiance};
}

}  // namespace hm
