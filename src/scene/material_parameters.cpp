#include "scene/material_parameters.h"

#include <algorithm>
#include <type_traits>

#include "scene/components.h"

namespace hm {
namespace {

constexpr BelowRange kClamp = BelowRange::clamp;
constexpr BelowRange kRefuse = BelowRange::refuse;

#define HM_ENTRY(owner, key, type, member, start, low, high, below, animated, extended, meaning) \
    {owner,                                                                                      \
     key,                                                                                        \
     #member,                                                                                    \
     AnimatedValue::member,                                                                      \
     sizeof(type) / sizeof(float),                                                               \
     start,                                                                                      \
     low,                                                                                        \
     high,                                                                                       \
     below,                                                                                      \
     animated,                                                                                   \
     extended,                                                                                   \
     meaning},
constexpr MaterialFactor kFactors[] = {
#define HM_FACTOR(owner, key, type, member, start, low, high, below, animated, table, meaning) \
    HM_ENTRY(owner, key, type, member, start, low, high, below, animated, false, meaning)
#define HM_EXTENDED_FACTOR(owner, key, type, member, start, low, high, below, animated, meaning) \
    HM_ENTRY(owner, key, type, member, start, low, high, below, animated, true, meaning)
#include "shading/material/parameters.inl"
};
#undef HM_ENTRY

constexpr MaterialTexture kTextures[] = {
#define HM_TEXTURE(owner, key, slot, read, encoding, meaning) \
    {owner, key, &Material::slot, encoding, meaning},
#include "shading/material/parameters.inl"
};

template <class AnyMaterial>
auto floats_of(AnyMaterial& material, AnimatedValue value) {
    using Float = std::conditional_t<std::is_const_v<AnyMaterial>, const float, float>;
    switch (value) {
#define HM_FACTOR(owner, key, type, member, start, low, high, below, animated, table, meaning) \
    case AnimatedValue::member:                                                                \
        return components(material.member);
#include "shading/material/parameters.inl"
        default:
            return std::span<Float>();
    }
}

}  // namespace

std::span<const MaterialFactor> material_factors() {
    return kFactors;
}

std::span<const MaterialTexture> material_textures() {
    return kTextures;
}

const MaterialFactor* find_material_factor(AnimatedValue value) {
    const auto* const found = std::find_if(std::begin(kFactors), std::end(kFactors),
                                           [&](const auto& f) { return f.value == value; });
    return found == std::end(kFactors) ? nullptr : found;
}

std::span<float> material_floats(Material& material, AnimatedValue value) {
    return floats_of(material, value);
}

std::span<const float> material_floats(const Material& material, AnimatedValue value) {
    return floats_of(material, value);
}

bool is_extended(const Material& m) {
    return m.specular_glossiness ||
#define HM_EXTENDED_FACTOR(owner, key, type, member, start, low, high, below, animated, meaning) \
    m.member != type(start) ||
#define HM_EXTENDED_TEXTURE(owner, key, slot, read, encoding, meaning) m.slot.image != kUnset ||
#include "shading/material/parameters.inl"
           false;
}

const TextureSlot* tangent_texture(const Material& m) {
    for (const TextureSlot* slot : {&m.normal_texture, &m.clearcoat_normal_texture})
        if (slot->image != kUnset) return slot;
    return m.anisotropy != 0 ? &m.anisotropy_texture : nullptr;
}

bool is_extension(std::string_view owner) {
    return owner.find('_') != owner.npos;  // keys of core glTF have no underscore
}

std::string pointer_in_material(std::string_view owner, std::string_view key) {
    std::string pointer;
    if (is_extension(owner)) pointer += "/extensions";
    if (!owner.empty()) pointer.append("/").append(owner);
    return pointer.append("/").append(key);
}

bool has_material_parameters(std::string_view extension) {
    const auto has = [&](const auto& parameter) { return parameter.owner == extension; };
    return is_extension(extension) &&
           (std::any_of(std::begin(kFactors), std::end(kFactors), has) ||
            std::any_of(std::begin(kTextures), std::end(kTextures), has));
}

}  // namespace hm
