#include "session/pose_choice.h"

namespace hm {

Result<std::optional<PoseTime>> choose_pose(const AnimationSettings& settings, const Scene& scene,
                                            Diagnostics& diagnostics) {
    if (settings.animation.empty() && !settings.at) return std::nullopt;
    PoseTime pose{0, double(settings.at.value_or(0))};
    if (!settings.animation.empty()) {
        HM_TRY_ASSIGN(pose.animation, find_animation(scene, settings.animation));
    } else if (scene.animations.empty()) {
        diagnostics.warn(scene.file, "", "has no animation; its pose is the same at any time");
        return std::nullopt;
    }
    return pose;
}

}  // namespace hm
