// The origin of the world coordinates that are rendered. Floats hold 24 bits, so a scene millions
// of metres away from the origin of its file (georeferenced CAD, IFC, 3D Tiles) loses its detail
// unless its position is subtracted from the nodes' transforms, in double precision, first.
#pragma once

#include "scene/scene.h"

namespace hm {

// Far is further, along an axis, than this many times the radius of the meshes' bounding box.
// Within that distance floats still resolve 2^-20 of the radius, so a scene is rendered about its
// file's own origin and its transforms are combined in floats.
inline constexpr double kFarInRadii = 16;

// Sets Scene::origin and Scene::double_precision from the rest pose, and rounds the nodes'
// transforms where floats are enough. The origin is the middle of the meshes where that is far,
// else zero; it is rounded to a multiple of a power of two no larger than the radius, so that
// coordinates read well. Skinned meshes have to be posed afterwards.
void set_origin(Scene& scene);

// Sets a node's transform, in the precision that the scene needs.
void set_local(const Scene& scene, Node& node, const Transform& transform);

}  // namespace hm
