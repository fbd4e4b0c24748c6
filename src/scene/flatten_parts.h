// The steps of flattening, in order of their dependencies. Each fills its tables of `flat`;
// scene/emitters.h is a further step, after the instances.
#pragma once

#include <vector>

#include "scene/flatten.h"

namespace hm {

// materials, texture_uses, images.
void flatten_materials(const Scene& scene, FlatScene& flat);

// geometries, geometry_views and mesh_first_geometry.
void flatten_geometries(const Scene& scene, FlatScene& flat);

// instances and bounds. `world` holds each node's world_transforms.
void flatten_instances(const Scene& scene, const std::vector<glm::dmat4>& world, FlatScene& flat,
                       Diagnostics& diagnostics);

// lights, light_alias and punctual_power. `scale` multiplies intensities.
void flatten_lights(const Scene& scene, const std::vector<glm::dmat4>& world, float scale,
                    FlatScene& flat);

// Warns about cameras and directional or spot lights whose transform degenerates their direction.
void warn_of_lost_directions(const Scene& scene, const std::vector<glm::dmat4>& world,
                             Diagnostics& diagnostics);

// Radius of the scene's bounding sphere in metres, clamped away from 0 and infinity.
double scene_radius(const Bounds& bounds);

}  // namespace hm
