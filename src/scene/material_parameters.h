// The table of material parameters (listed in shading/material/parameters.inl).
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

// A scalar or vector parameter of a material.
struct MaterialFactor {
    std::string_view owner;  // the JSON object that contains the key, see parameters.inl
    std::string_view key;
    std::string_view name;  // of the member of Material: "base_color"
    AnimatedValue value;
    std::size_t components;
    float start;      // default value of every component
    float low, high;  // -/+ the largest float where there is no limit
    BelowRange below;
    bool animated;  // false: animating it does not affect the image
    bool extended;  // a member of ExtendedMaterialData, so most materials have its default
    std::string_view meaning;
};

struct MaterialTexture {
    std::string_view owner;
    std::string_view key;
    TextureSlot Material::*slot;
    std::uint32_t encoding;  // kEncoding*
    std::string_view meaning;
};

// Consecutive entries often share their owner.
std::span<const MaterialFactor> material_factors();
std::span<const MaterialTexture> material_textures();

// Null if the value is not a material parameter.
const MaterialFactor* find_material_factor(AnimatedValue value);

// The factor's components; empty if the value is not a material parameter.
std::span<float> material_floats(Material& material, AnimatedValue value);
std::span<const float> material_floats(const Material& material, AnimatedValue value);

// Whether it needs a row in extended_materials: it is a specular-glossiness material, or an
// HM_EXTENDED_ entry of the list is not as it starts.
bool is_extended(const Material& material);

// Whether its mesh bounds a volume, of which a scene may have kMaxVolumes.
inline bool has_volume(const Material& material) {
    return material.thickness > 0;
}

// The texture whose coordinates give the material's tangents, where the file has none: that of the
// normal map, else of the coat's, else the direction of anisotropy. Null if nothing needs tangents.
const TextureSlot* tangent_texture(const Material& material);

// Whether the owner is the object of an extension, or within one.
bool is_extension(std::string_view owner);
// JSON pointer from the material to the property.
std::string pointer_in_material(std::string_view owner, std::string_view key);

// Whether the list contains parameters of this extension.
bool has_material_parameters(std::string_view extension);

}  // namespace hm
