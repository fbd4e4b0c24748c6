// Keyframe animation as specified by glTF 2.0 (3.11 and Appendix C): samplers, and the channels
// that bind each sampler to its target.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "shading/lang.h"

namespace hm {

enum class Interpolation { step, linear, cubic_spline };

struct AnimationSampler {
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times;  // seconds; strictly increasing, not empty
    // One value of width() floats per key time; for cubic splines the in-tangent, the value and the
    // out-tangent.
    std::vector<float> values;

    std::size_t width() const;
};

enum class AnimatedProperty { translation, rotation, scale, weights };

struct Channel {
    std::size_t sampler = 0;  // into Animation::samplers
    std::size_t node = 0;     // into Scene::nodes
    AnimatedProperty property = AnimatedProperty::translation;
};

// Animated values other than node transforms and weights (animated_values.h). Material values are
// named after the members of Material. Generated from the two lists.
enum class AnimatedValue {
    node_visible,
#define HM_FACTOR(owner, key, type, member, start, low, high, below, animated, table, meaning) \
    member,
#include "shading/material/parameters.inl"
#define HM_ANIMATED(value, pointer, table, member, low, high) value,
#include "scene/animated_values.inl"
};

struct ValueChannel {
    std::size_t sampler = 0;  // into Animation::samplers
    AnimatedValue value = AnimatedValue::node_visible;
    std::size_t owner = 0;        // into the scene's nodes, materials, lights or cameras
    std::array<float, 4> rest{};  // used when no animation sets the value
};

// No two channels target the same property of the same object.
struct Animation {
    std::string name;
    std::vector<AnimationSampler> samplers;
    std::vector<Channel> channels;
    std::vector<ValueChannel> values{};
};

// Evaluates the sampler at a time, which is clamped to the range of the keys. `out` has room for
// width() numbers.
void evaluate(const AnimationSampler& sampler, double seconds, std::span<float> out);
void evaluate(const AnimationSampler& sampler, double seconds, std::span<double> out);

// The same for quaternions (width 4, none of length zero); returns a unit quaternion. Linear
// interpolation is slerp along the shorter great arc.
glm::dvec4 evaluate_rotation(const AnimationSampler& sampler, double seconds);

}  // namespace hm
