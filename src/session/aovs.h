// What AOVs need of a scene: light groups, names, and the pose of the next frame.
#pragma once

#include <optional>

#include "film/aov.h"
#include "scene/flatten.h"
#include "scene/motion.h"
#include "scene/pose.h"
#include "scene/surface_names.h"
#include "session/settings.h"

namespace hm {

// If the motion AOV is chosen and the scene moves: its pose one frame, 1 / fps seconds, after
// `pose`. Leaves the scene in that pose.
Result<std::optional<PoseRecord>> record_next_pose(const RenderSettings& settings, Scene& scene,
                                                   const std::optional<PoseTime>& pose);

struct AovSetup {
    AovSelection selection;
    glm::dvec3 origin{0};  // Scene::origin
    SurfaceNames names;    // if a cryptomatte is chosen
};

// Also fills flat.aovs.
AovSetup prepare_aovs(const RenderSettings& settings, const Scene& scene, FlatScene& flat,
                      const std::optional<PoseRecord>& next_pose);

}  // namespace hm
