#include "scene/animated_values.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace hm {
namespace {

// Where the value's numbers stand. A node's visibility is none.
template <class AnyScene>
auto floats_of(AnyScene& scene, AnimatedValue value, std::size_t owner) {
    using Float = std::conditional_t<std::is_const_v<AnyScene>, const float, float>;
    using Floats = std::span<Float>;
    switch (value) {
        case AnimatedValue::node_visible:
            break;
        case AnimatedValue::base_color:
            return Floats(&scene.materials[owner].base_color.x, 4);
        case AnimatedValue::metallic:
            return Floats(&scene.materials[owner].metallic, 1);
        case AnimatedValue::roughness:
            return Floats(&scene.materials[owner].roughness, 1);
        case AnimatedValue::emissive_factor:
            return Floats(&scene.materials[owner].emissive_factor.x, 3);
        case AnimatedValue::emissive_strength:
            return Floats(&scene.materials[owner].emissive_strength, 1);
        case AnimatedValue::alpha_cutoff:
            return Floats(&scene.materials[owner].alpha_cutoff, 1);
        case AnimatedValue::normal_scale:
            return Floats(&scene.materials[owner].normal_scale, 1);
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
    }
    return Floats();
}

struct Range {
    float low, high;
};

Range range_of(AnimatedValue value) {
    constexpr float kMost = std::numeric_limits<float>::max();
    constexpr float kLeast = 1e-4f;  // of what must be above 0
    constexpr float kPi = 3.14159265f;
    switch (value) {
        case AnimatedValue::node_visible:
        case AnimatedValue::base_color:
        case AnimatedValue::metallic:
        case AnimatedValue::roughness:
        case AnimatedValue::emissive_factor:
            return {0, 1};
        case AnimatedValue::emissive_strength:
        case AnimatedValue::alpha_cutoff:
        case AnimatedValue::light_color:
        case AnimatedValue::light_intensity:
            return {0, kMost};
        case AnimatedValue::normal_scale:
            return {-kMost, kMost};
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
    }
    return {0, 0};
}

}  // namespace

std::size_t width(AnimatedValue value) {
    switch (value) {
        case AnimatedValue::base_color:
            return 4;
        case AnimatedValue::emissive_factor:
        case AnimatedValue::light_color:
            return 3;
        default:
            return 1;
    }
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
    if (value == AnimatedValue::emissive_factor || value == AnimatedValue::emissive_strength) {
        Material& material = scene.materials[owner];
        material.emissive = material.emissive_factor * material.emissive_strength;
    }
}

void clamp_value(AnimatedValue value, std::span<float> numbers) {
    const Range range = range_of(value);
    for (float& number : numbers)
        number = std::clamp(number, range.low, range.high);
}

}  // namespace hm
