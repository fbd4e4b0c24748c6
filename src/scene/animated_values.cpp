#include "scene/animated_values.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "scene/material_parameters.h"

namespace hm {
namespace {

// The floats that store the value; empty for node visibility, which is not a float.
template <class AnyScene>
auto floats_of(AnyScene& scene, AnimatedValue value, std::size_t owner) {
    using Float = std::conditional_t<std::is_const_v<AnyScene>, const float, float>;
    using Floats = std::span<Float>;
    if (find_material_factor(value)) return material_floats(scene.materials[owner], value);
    switch (value) {
        case AnimatedValue::light_color:
            return Floats(&scene.lights[owner].color.x, 3);
        case AnimatedValue::light_intensity:
            return Floats(&scene.lights[owner].intensity, 1);
        case AnimatedValue::light_range:
            return Floats(&scene.lights[owner].range, 1);
        case AnimatedValue::inner_cone:
            return Floats(&scene.lights[owner].inner_cone, 1);
        case AnimatedValue::outer_cone:
            return Floats(&scene.lights[owner].outer_cone, 1);
        case AnimatedValue::yfov:
            return Floats(&scene.cameras[owner].yfov, 1);
        case AnimatedValue::xmag:
            return Floats(&scene.cameras[owner].xmag, 1);
        case AnimatedValue::ymag:
            return Floats(&scene.cameras[owner].ymag, 1);
        default:
            return Floats();
    }
}

struct Range {
    float low, high;
};

Range range_of(AnimatedValue value) {
    constexpr float kMost = std::numeric_limits<float>::max();
    constexpr float kLeast = 1e-4f;  // lower limit of values that must be above 0
    constexpr float kPi = 3.14159265f;
    if (const MaterialFactor* factor = find_material_factor(value))
        return {factor->low, factor->high};
    switch (value) {
        case AnimatedValue::node_visible:
            return {0, 1};
        case AnimatedValue::light_color:
        case AnimatedValue::light_intensity:
            return {0, kMost};
        case AnimatedValue::light_range:
        case AnimatedValue::xmag:
        case AnimatedValue::ymag:
            return {kLeast, kMost};
        case AnimatedValue::inner_cone:
            return {0, kPi / 2};
        case AnimatedValue::outer_cone:
            return {kLeast, kPi / 2};
        case AnimatedValue::yfov:
            return {kLeast, kPi - kLeast};
        default:
            return {0, 0};
    }
}

}  // namespace

std::size_t width(AnimatedValue value) {
    if (const MaterialFactor* factor = find_material_factor(value)) return factor->components;
    return value == AnimatedValue::light_color ? 3 : 1;
}

std::array<float, 4> get_value(const Scene& scene, AnimatedValue value, std::size_t owner) {
    std::array<float, 4> out{};
    if (value == AnimatedValue::node_visible) {
        out[0] = scene.nodes[owner].visible ? 1.0f : 0.0f;
        return out;
    }
    const auto from = floats_of(scene, value, owner);
    std::copy(from.begin(), from.end(), out.begin());
    return out;
}

void set_value(Scene& scene, AnimatedValue value, std::size_t owner, std::span<const float> to) {
    if (value == AnimatedValue::node_visible) {
        scene.nodes[owner].visible = to[0] != 0;
        return;
    }
    const auto floats = floats_of(scene, value, owner);
    std::copy_n(to.begin(), floats.size(), floats.begin());
}

void clamp_value(AnimatedValue value, std::span<float> numbers) {
    const Range range = range_of(value);
    for (float& number : numbers)
        number = std::clamp(number, range.low, range.high);
}

}  // namespace hm
