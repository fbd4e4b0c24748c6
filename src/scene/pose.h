// Poses a scene at a given time of its animations.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace hm {

struct PoseTime {
    // Into Scene::animations. They play together; the last that sets a value wins.
    std::vector<std::size_t> animations{};
    double seconds = 0;
};

// Sets the node transforms, the vertices of all meshes with morph targets or a skin, and all other
// animated values; without a time, restores the rest pose. Everything is computed from the rest
// pose, so the result does not depend on earlier poses. Fails if the animation's values overflow.
Result<void> pose_scene(Scene& scene, const std::optional<PoseTime>& at);

// Finds an animation by name or index; names take precedence. Fails with
// ErrorKind::invalid_argument.
Result<std::size_t> find_animation(const Scene& scene, const std::string& wanted);

// How many properties are targets of more than one of the scene's animations.
std::size_t count_shared_targets(const Scene& scene);

}  // namespace hm
