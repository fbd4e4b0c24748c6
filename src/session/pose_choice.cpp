#include "session/pose_choice.h"

#include <fmt/format.h>

#include <numeric>

namespace hm {
namespace {

std::vector<std::size_t> all_animations(const Scene& scene, Diagnostics& diagnostics) {
    std::vector<std::size_t> animations(scene.animations.size());
    std::iota(animations.begin(), animations.end(), std::size_t{0});
    if (const std::size_t shared = count_shared_targets(scene); shared > 0)
        diagnostics.warn(scene.file, "/animations",
                         fmt::format("several animations set the same property; the last one of "
                                     "the file wins (properties: {})",
                                     shared));
    return animations;
}

}  // namespace

Result<std::optional<PoseTime>> choose_pose(const AnimationSettings& settings, const Scene& scene,
                                            Diagnostics& diagnostics) {
    if (settings.animation.empty() && !settings.at) return std::nullopt;
    PoseTime pose{{0}, double(settings.at.value_or(0))};
    const bool plays_all = settings.animation == kAllAnimations;
    const std::size_t count = scene.animations.size();
    if (count == 0 && (plays_all || settings.animation.empty())) {
        diagnostics.warn(scene.file, "", "has no animation; its pose is the same at any time");
        return std::nullopt;
    }
    if (plays_all) {
        pose.animations = all_animations(scene, diagnostics);
    } else if (!settings.animation.empty()) {
        HM_TRY_ASSIGN(pose.animations[0], find_animation(scene, settings.animation));
    } else if (count > 1) {
        diagnostics.warn(scene.file, "/animations",
                         fmt::format("only the first of {} animations, \"{}\", plays; animation "
                                     "\"{}\" plays them together",
                                     count, scene.animations[0].name, kAllAnimations));
    }
    return pose;
}

}  // namespace hm
