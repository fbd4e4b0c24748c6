// A scene at a moment of one of its animations.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/result.h"
#include "scene/scene.h"

namespace hm {

struct PoseTime {
    std::size_t animation = 0;  // into Scene::animations
    double seconds = 0;
};

// Sets the nodes' transforms, the vertices of every mesh that morphs or has a skin, and the values
// that animations set; without a time, to the rest pose. Everything is computed from the rest
// pose, so what was posed before does not matter. Fails where the animation's values overflow.
Result<void> pose_scene(Scene& scene, const std::optional<PoseTime>& at);

// The animation of this name or index; the name wins. Fails with ErrorKind::invalid_argument.
Result<std::size_t> find_animation(const Scene& scene, const std::string& wanted);

}  // namespace hm
