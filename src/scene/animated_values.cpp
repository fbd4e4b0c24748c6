#include "scene/animated_values.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "scene/components.h"
#include "scene/material_parameters.h"

namespace hm {
namespace {

// The floats that store the value; empty for node visibility, which is not a float.
template <class AnyScene>
auto floats_of(AnyScene& scene, AnimatedValue value, std::size_t owner) {
    using Float = std::conditional_t<std::is_const_v<AnyScene>, const float, float>;
    if (find_material_factor(value)) return material_floats(scene.materials[owner], value);
    switch (value) {
#define HM_ANIMATED(value, pointer, table, member, low, high) \
    case AnimatedValue::value:                                \
        return components(scene.table[owner].member);
#include "scene/animated_values.inl"
        default:
            return std::span<Float>();
    }
}

struct Numbers {
    std::size_t count;
    float low, high;
};

Numbers numbers_of(AnimatedValue value) {
    constexpr float kMost = std::numeric_limits<float>::max();
    constexpr float kLeast = 1e-4f;
    constexpr float kPi = 3.14159265f;
    if (const MaterialFactor* factor = find_material_factor(value))
        return {factor->components, factor->low, factor->high};
    switch (value) {
#define HM_ANIMATED(value, pointer, table, member, low, high) \
    case AnimatedValue::value:                                \
        return {sizeof(Scene{}.table[0].member) / sizeof(float), low, high};
#include "scene/animated_values.inl"
        default:  // node visibility
            return {1, 0, 1};
    }
}

}  // namespace

std::size_t width(AnimatedValue value) {
    return numbers_of(value).count;
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
    const Numbers range = numbers_of(value);
    for (float& number : numbers)
        number = std::clamp(number, range.low, range.high);
}

}  // namespace hm
