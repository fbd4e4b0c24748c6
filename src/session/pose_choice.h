// The pose of an animated scene.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/pose.h"
#include "session/settings.h"

namespace hm {

// The animations and their time; nothing for the rest pose. Warns of animations that are left out
// because none was named, and of several that set the same property. Fails with
// ErrorKind::invalid_argument if the scene does not have the animation.
Result<std::optional<PoseTime>> choose_pose(const AnimationSettings& settings, const Scene& scene,
                                            Diagnostics& diagnostics);

}  // namespace hm
