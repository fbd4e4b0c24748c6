// From a scene's camera, or from a point of view, to what shading reads.
#pragma once

#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm {

// A camera node's view. `aspect` is width / height of the picture; the file's yfov (or ymag) is
// kept. The lens is a pinhole until lens_radius is set.
CameraData camera_from_node(const Camera& camera, const glm::mat4& world, float aspect);

// eye and target in metres, yfov in radians.
CameraData camera_look_at(vec3 eye, vec3 target, vec3 up, float yfov, float aspect);

// Frames the bounds from a little above, from the front right (+z, +x).
CameraData camera_framing(const Bounds& bounds, float yfov, float aspect);

}  // namespace hm
