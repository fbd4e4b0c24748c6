// Values of a scene that an animation can set in addition to the nodes' transforms and weights:
// material factors, lights, cameras and the nodes' visibility (KHR_animation_pointer).
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "scene/scene.h"

namespace hm {

// Numbers that the value consists of; a node's visibility is one, 0 or 1.
std::size_t width(AnimatedValue value);

// The first width() elements are the value as it stands in the scene.
std::array<float, 4> get_value(const Scene& scene, AnimatedValue value, std::size_t owner);

// `to` has width() elements, which are taken as they are.
void set_value(Scene& scene, AnimatedValue value, std::size_t owner, std::span<const float> to);

// Pulls what interpolation made to the nearest number that the value may be.
void clamp_value(AnimatedValue value, std::span<float> numbers);

}  // namespace hm
