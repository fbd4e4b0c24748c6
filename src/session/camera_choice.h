// The camera of a picture: the file's, one that looks at a point, or one that frames the scene.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "scene/flatten.h"
#include "scene/scene.h"
#include "session/fingerprint.h"
#include "session/settings.h"

namespace hm {

struct CameraChoice {
    CameraData data;
    std::string name;  // "camera 0 (name)", "look-at" or "framing"
};

// Without settings, a first camera that cannot be used counts as none. Fails with
// ErrorKind::invalid_argument if the settings do not fit the scene, and with Camera::fault if that
// of the chosen camera is set. `world` has the nodes' transforms if they are not those of the
// scene's current pose.
Result<CameraChoice> choose_camera(const ViewSettings& view, const Scene& scene,
                                   const Bounds& bounds, float aspect);
Result<CameraChoice> choose_camera(const ViewSettings& view, const Scene& scene,
                                   const std::vector<glm::dmat4>& world, const Bounds& bounds,
                                   float aspect);

// The view settings that reproduce this camera of a scene with this origin; empty for an
// orthographic camera, which has none.
NamedValues view_of(const CameraData& camera, const glm::dvec3& origin);

}  // namespace hm
