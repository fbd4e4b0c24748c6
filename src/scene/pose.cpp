#include "scene/pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <variant>

#include "scene/animated_values.h"
#include "scene/origin.h"

namespace hm {
namespace {

template <class Vector>
bool all_finite(const Vector& v) {
    for (typename Vector::length_type i = 0; i < Vector::length(); ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

// Whether 32-bit floats can hold it.
bool is_finite(const glm::mat4& m) {
    return all_finite(m[0]) && all_finite(m[1]) && all_finite(m[2]) && all_finite(m[3]);
}

glm::dvec3 evaluate_vector(const AnimationSampler& sampler, double seconds) {
    std::array<double, 3> out{};
    evaluate(sampler, seconds, out);
    return {out[0], out[1], out[2]};
}

// Per-node values that animation channels override.
struct Pose {
    std::vector<Transform> transforms;        // used for nodes with a rest transform
    std::vector<std::vector<float>> weights;  // used for nodes with animated weights
};

Pose rest_pose(const Scene& scene) {
    Pose pose;
    for (const Node& node : scene.nodes)
        pose.transforms.push_back(node.rest.value_or(Transform{}));
    pose.weights.resize(scene.nodes.size());
    return pose;
}

const std::vector<float>& target_weights(const Scene& scene, const Pose& pose, std::size_t node) {
    if (!pose.weights[node].empty()) return pose.weights[node];
    if (!scene.nodes[node].weights.empty()) return scene.nodes[node].weights;
    return scene.meshes[std::size_t(scene.nodes[node].mesh)].weights;
}

void apply(const Animation& animation, double seconds, Pose& pose) {
    for (const Channel& channel : animation.channels) {
        const AnimationSampler& sampler = animation.samplers[channel.sampler];
        Transform& transform = pose.transforms[channel.node];
        switch (channel.property) {
            case AnimatedProperty::translation:
                transform.translation = evaluate_vector(sampler, seconds);
                break;
            case AnimatedProperty::rotation:
                transform.rotation = evaluate_rotation(sampler, seconds);
                break;
            case AnimatedProperty::scale:
                transform.scale = evaluate_vector(sampler, seconds);
                break;
            case AnimatedProperty::weights:
                pose.weights[channel.node].resize(sampler.width());
                evaluate(sampler, seconds, pose.weights[channel.node]);
                break;
        }
    }
}

void reset_values(Scene& scene) {
    for (const Animation& animation : scene.animations)
        for (const ValueChannel& channel : animation.values)
            set_value(scene, channel.value, channel.owner, channel.rest);
}

Result<void> apply_values(Scene& scene, std::size_t animation, double seconds) {
    const auto overflows = [&](const char* what) {
        return fail(ErrorKind::invalid, scene.file, fmt::format("/animations/{}", animation),
                    fmt::format("{} overflows a 32-bit float at this time", what));
    };
    for (const ValueChannel& channel : scene.animations[animation].values) {
        std::array<float, 4> numbers{};
        const std::span<float> value(numbers.data(), width(channel.value));
        evaluate(scene.animations[animation].samplers[channel.sampler], seconds, value);
        for (const float number : value)
            if (!std::isfinite(number)) return overflows("a value");
        clamp_value(channel.value, value);
        set_value(scene, channel.value, channel.owner, value);
    }
    for (const Light& light : scene.lights)
        if (!all_finite(light.color * light.intensity)) return overflows("a light");
    return {};
}

// Transform from the space of the rest vertices to world space, per joint.
std::vector<glm::mat4> joint_matrices(const Skin& skin, const std::vector<glm::dmat4>& world) {
    std::vector<glm::mat4> out;
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
        out.emplace_back(world[std::size_t(skin.joints[i])] * glm::dmat4(skin.inverse_bind[i]));
    return out;
}

bool mostly_mirror(const std::vector<glm::mat4>& matrices) {
    const auto mirrors = [](const glm::mat4& m) {
        return glm::determinant(glm::dmat3(glm::dmat4(m))) < 0;
    };
    return 2 * std::count_if(matrices.begin(), matrices.end(), mirrors) >
           std::ptrdiff_t(matrices.size());
}

tl::unexpected<Error> overflows(const Scene& scene, const Node& node, const char* what) {
    return fail(ErrorKind::invalid, scene.file, pointer_of(node),
                fmt::format("the {} of node \"{}\" overflows a 32-bit float at this time", what,
                            node.name));
}

bool is_finite(const Primitive& primitive) {
    for (const Vertex& v : primitive.vertices)
        if (!all_finite(v.position) || !all_finite(v.uv0)) return false;
    for (const VertexExtra& e : primitive.extras)
        if (!all_finite(e.uv1) || !all_finite(e.color)) return false;
    return true;
}

Result<void> deform_meshes(Scene& scene, const Pose& pose, const std::vector<glm::dmat4>& world) {
    std::vector<bool> done(scene.meshes.size(), false);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        Node& node = scene.nodes[i];
        if (node.mesh == kUnset) continue;
        std::vector<glm::mat4> joints;
        if (node.skin != kUnset)
            joints = joint_matrices(scene.skins[std::size_t(node.skin)], world);
        node.skin_mirrors = mostly_mirror(joints);
        if (done[std::size_t(node.mesh)]) continue;
        done[std::size_t(node.mesh)] = true;
        for (Primitive& p : scene.meshes[std::size_t(node.mesh)].primitives) {
            if (!p.deformation) continue;
            deform(*p.deformation, target_weights(scene, pose, i), joints, p.vertices, p.extras);
            if (!is_finite(p)) return overflows(scene, node, "mesh");
        }
    }
    return {};
}

}  // namespace

Result<void> pose_scene(Scene& scene, const std::optional<PoseTime>& at) {
    Pose pose = rest_pose(scene);
    reset_values(scene);
    if (at)
        for (const std::size_t animation : at->animations) {
            apply(scene.animations[animation], at->seconds, pose);
            HM_TRY(apply_values(scene, animation, at->seconds));
        }
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        if (scene.nodes[i].rest) set_local(scene, scene.nodes[i], pose.transforms[i]);
    const std::vector<glm::dmat4> world = world_transforms(scene);
    for (std::size_t i = 0; i < world.size(); ++i)
        if (!is_finite(glm::mat4(world[i])))
            return overflows(scene, scene.nodes[i], "world transform");
    return deform_meshes(scene, pose, world);
}

Result<std::size_t> find_animation(const Scene& scene, const std::string& wanted) {
    std::string known;
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        if (scene.animations[i].name == wanted) return i;
        known += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i, scene.animations[i].name);
    }
    std::size_t index = 0;
    const char* const end = wanted.data() + wanted.size();
    const auto [stopped, error] = std::from_chars(wanted.data(), end, index);
    if (error == std::errc() && stopped == end && index < scene.animations.size()) return index;
    return fail_setting("animation",
                        fmt::format("there is no animation \"{}\"; the file has {}", wanted,
                                    known.empty() ? "none" : known),
                        scene.file);
}

std::size_t count_shared_targets(const Scene& scene) {
    using Target = std::pair<std::size_t, std::variant<AnimatedProperty, AnimatedValue>>;
    std::map<Target, std::size_t> uses;  // no animation has a target twice
    for (const Animation& animation : scene.animations) {
        for (const Channel& channel : animation.channels)
            ++uses[{channel.node, channel.property}];
        for (const ValueChannel& channel : animation.values)
            ++uses[{channel.owner, channel.value}];
    }
    return std::size_t(
        std::ranges::count_if(uses, [](const auto& target) { return target.second > 1; }));
}

}  // namespace hm
