// The table of a material's parameters (shading/material/parameters.inl has the list).
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/animation.h"
#include "scene/scene.h"

namespace hm {

enum class BelowRange { clamp, refuse };

// A number or a vector of a material.
struct MaterialFactor {
    std::string_view owner;  // the object that has the key, see parameters.inl
    std::string_view key;
    AnimatedValue value;
    std::size_t components;
    float start;      // its default, in every component
    float low, high;  // low and high are +-float's largest where there is no limit
    BelowRange below;
    bool animated;  // false: animating it changes no picture
    std::string_view meaning;
};

struct MaterialTexture {
    std::string_view owner;
    std::string_view key;
    TextureSlot Material::*slot;
    std::uint32_t encoding;  // kEncoding*
    std::string_view meaning;
};

// Neighbours in a list often share their owner.
std::span<const MaterialFactor> material_factors();
std::span<const MaterialTexture> material_textures();

// Null for values that are not of a material.
const MaterialFactor* find_material_factor(AnimatedValue value);

// The factor's components; empty for values that are not of a material.
std::span<float> material_floats(Material& material, AnimatedValue value);
std::span<const float> material_floats(const Material& material, AnimatedValue value);

// Whether an owner is an extension's object.
bool is_extension(std::string_view owner);
// JSON pointer from the material to the property.
std::string pointer_in_material(std::string_view owner, std::string_view key);

// Whether the list has parameters of this extension.
bool has_material_parameters(std::string_view extension);

}  // namespace hm
