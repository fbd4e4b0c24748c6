// The parts of flattening, in the order in which they build on each other. Each fills its tables of
// `flat`; scene/emitters.h is one more, after the instances.
#pragma once

#include <vector>

#include "scene/flatten.h"

namespace hm {

// materials, texture_uses, images.
void flatten_materials(const Scene& scene, FlatScene& flat);

// geometries, geometry_views and mesh_first_geometry.
void flatten_geometries(const Scene& scene, FlatScene& flat);

// instances and bounds. `world` has each node's transform.
void flatten_instances(const Scene& scene, const std::vector<glm::mat4>& world, FlatScene& flat,
                       Diagnostics& diagnostics);

// lights, light_alias and punctual_power.
void flatten_lights(const Scene& scene, const std::vector<glm::mat4>& world, FlatScene& flat);

// Warns about cameras and aimed lights whose transform leaves no direction.
void warn_of_lost_directions(const Scene& scene, const std::vector<glm::mat4>& world,
                             Diagnostics& diagnostics);

// The radius of a sphere around the scene, kept away from 0 and infinity, in metres.
double scene_radius(const Bounds& bounds);

}  // namespace hm
