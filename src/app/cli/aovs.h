// What AOVs need of a scene: light groups, names, and the pose of the next frame.
#pragma once

#include <optional>

#include "app/cli/options.h"
#include "film/aov.h"
#include "scene/flatten.h"
#include "scene/motion.h"
#include "scene/pose.h"
#include "scene/surface_names.h"

namespace hm::cli {

// Where motion is asked for and the scene moves: its pose one frame, 1 / fps seconds, after `pose`.
// Leaves the scene in that pose.
Result<std::optional<PoseRecord>> record_next_pose(const RenderOptions& options, Scene& scene,
                                                   const std::optional<PoseTime>& pose);

struct AovSetup {
    AovSelection selection;
    SurfaceNames names;  // where a cryptomatte is chosen
};

// Also fills flat.aovs.
AovSetup prepare_aovs(const RenderOptions& options, const Scene& scene, FlatScene& flat,
                      const std::optional<PoseRecord>& next_pose);

}  // namespace hm::cli
