// Builds the camera data that shading reads, from a scene's camera or from a viewpoint.
#pragma once

#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm {

// The view of a camera node. `aspect` is width / height of the image; the file's yfov (or ymag) is
// kept. The camera is a pinhole until lens_radius is set.
CameraData camera_from_node(const Camera& camera, const glm::mat4& world, float aspect);

// eye and target are in metres, yfov in radians.
CameraData camera_look_at(vec3 eye, vec3 target, vec3 up, float yfov, float aspect);

// Frames the bounds, seen from slightly above and from the front right (+z, +x).
CameraData camera_framing(const Bounds& bounds, float yfov, float aspect);

}  // namespace hm
