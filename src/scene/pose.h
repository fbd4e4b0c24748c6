// Poses a scene at a given time of one of its animations.
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

// Sets the node transforms, the vertices of all meshes with morph targets or a skin, and all other
// animated values; without a time, restores the rest pose. Everything is computed from the rest
// pose, so the result does not depend on earlier poses. Fails if the animation's values overflow.
Result<void> pose_scene(Scene& scene, const std::optional<PoseTime>& at);

// Finds an animation by name or index; names take precedence. Fails with
// ErrorKind::invalid_argument.
Result<std::size_t> find_animation(const Scene& scene, const std::string& wanted);

}  // namespace hm
