// Scene properties that an animation can set in addition to node transforms and morph weights:
// material factors, lights, cameras and node visibility (KHR_animation_pointer).
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "scene/scene.h"

namespace hm {

// Number of components of the value; node visibility has one component, 0 or 1.
std::size_t width(AnimatedValue value);

// The first width() elements hold the current value in the scene.
std::array<float, 4> get_value(const Scene& scene, AnimatedValue value, std::size_t owner);

// `to` has width() elements, which are not clamped or validated.
void set_value(Scene& scene, AnimatedValue value, std::size_t owner, std::span<const float> to);

// Clamps an interpolated value to the nearest valid one.
void clamp_value(AnimatedValue value, std::span<float> numbers);

}  // namespace hm
