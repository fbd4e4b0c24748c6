#include "gltf/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "gltf/textures.h"

namespace hm::gltf {
namespace {

constexpr float kNoLimit = std::numeric_limits<float>::max();

// Values outside of what the schema allows are pulled to its limit, with a warning.
float limited(Source& source, const Json& json, std::string_view key, float value, float low,
              float high) {
    if (value < low || value > high)
        source.warn(json.pointer_of(key),
                    high == kNoLimit ? fmt::format("below {}, raised to it", low)
                                     : fmt::format("outside {} to {}, clamped", low, high));
    return std::clamp(value, low, high);
}

Result<float> read_factor(Source& source, const Json& json, std::string_view key, float fallback,
                          float high = 1) {
    HM_TRY_ASSIGN(const float value, json.number_or(key, fallback));
    return limited(source, json, key, value, 0, high);
}

// One "...Texture" property; the slot stays unset where it is absent.
Result<std::optional<Json>> read_slot(Source& source, const Json& json, std::string_view key,
                                      const std::vector<Texture>& textures, TextureSlot& slot) {
    HM_TRY_ASSIGN(auto info, json.object(key));
    if (info) {
        HM_TRY_ASSIGN(slot, read_texture_slot(*info, textures, source));
    }
    return info;
}

Result<void> read_metallic_roughness(Source& source, const Json& json,
                                     const std::vector<Texture>& textures, Material& material) {
    HM_TRY_ASSIGN(const auto pbr, json.object("pbrMetallicRoughness"));
    if (!pbr) return {};
    std::array<float, 4> color{1, 1, 1, 1};
    HM_TRY(pbr->numbers("baseColorFactor", color));
    for (float& component : color)
        component = limited(source, *pbr, "baseColorFactor", component, 0, 1);
    material.base_color = vec4(color[0], color[1], color[2], color[3]);
    HM_TRY_ASSIGN(material.metallic, read_factor(source, *pbr, "metallicFactor", 1));
    HM_TRY_ASSIGN(material.roughness, read_factor(source, *pbr, "roughnessFactor", 1));
    HM_TRY(read_slot(source, *pbr, "baseColorTexture", textures, material.base_color_texture));
    HM_TRY(read_slot(source, *pbr, "metallicRoughnessTexture", textures,
                     material.metallic_roughness_texture));
    return {};
}

// Negative light means nothing, so it is refused; a factor above 1 is clamped as the schema has it.
Result<void> read_emission(Source& source, const Json& json, const std::vector<Texture>& textures,
                           Material& material) {
    std::array<float, 3> factor{0, 0, 0};
    HM_TRY(json.numbers("emissiveFactor", factor));
    for (float& component : factor) {
        if (component < 0) return json.invalid("emissiveFactor", "must not be negative");
        component = limited(source, json, "emissiveFactor", component, 0, 1);
    }
    float strength = 1;
    HM_TRY_ASSIGN(const auto extension, json.extension("KHR_materials_emissive_strength"));
    if (extension) {
        HM_TRY_ASSIGN(strength, extension->number_or("emissiveStrength", 1));
        if (strength < 0) return extension->invalid("emissiveStrength", "must not be negative");
    }
    material.emissive_factor = vec3(factor[0], factor[1], factor[2]);
    material.emissive_strength = strength;
    material.emissive = material.emissive_factor * strength;
    HM_TRY(read_slot(source, json, "emissiveTexture", textures, material.emissive_texture));
    return {};
}

Result<void> read_alpha(Source& source, const Json& json, Material& material) {
    HM_TRY_ASSIGN(const auto mode, json.text("alphaMode"));
    if (!mode || *mode == "OPAQUE") {
        material.alpha_mode = kAlphaOpaque;
    } else if (*mode == "MASK") {
        material.alpha_mode = kAlphaMask;
    } else if (*mode == "BLEND") {
        material.alpha_mode = kAlphaBlend;
    } else {
        return json.invalid("alphaMode", fmt::format("{} is no alpha mode", excerpt(*mode)));
    }
    HM_TRY_ASSIGN(material.alpha_cutoff, read_factor(source, json, "alphaCutoff", 0.5f, kNoLimit));
    return {};
}

Result<Material> read_material(Source& source, const Json& json,
                               const std::vector<Texture>& textures) {
    Material material;
    HM_TRY_ASSIGN(material.name, json.name());
    HM_TRY(read_metallic_roughness(source, json, textures, material));
    HM_TRY(read_emission(source, json, textures, material));
    HM_TRY(read_alpha(source, json, material));
    HM_TRY_ASSIGN(material.double_sided, json.flag("doubleSided"));
    HM_TRY_ASSIGN(const auto unlit, json.extension("KHR_materials_unlit"));
    material.unlit = unlit.has_value();

    HM_TRY_ASSIGN(const auto normal,
                  read_slot(source, json, "normalTexture", textures, material.normal_texture));
    if (normal) {
        HM_TRY_ASSIGN(material.normal_scale, normal->number_or("scale", 1));
    }
    HM_TRY_ASSIGN(const auto occlusion, read_slot(source, json, "occlusionTexture", textures,
                                                  material.occlusion_texture));
    if (occlusion) {
        HM_TRY_ASSIGN(material.occlusion_strength, read_factor(source, *occlusion, "strength", 1));
    }
    return material;
}

}  // namespace

std::array<const TextureSlot*, 5> texture_slots(const Material& m) {
    return {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
            &m.occlusion_texture, &m.emissive_texture};
}

std::array<TextureSlot*, 5> texture_slots(Material& m) {
    return {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
            &m.occlusion_texture, &m.emissive_texture};
}

Result<std::vector<Material>> read_materials(const Json& root, Source& source) {
    HM_TRY_ASSIGN(const std::vector<Texture> textures, read_textures(root));
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("materials"));
    std::vector<Material> materials;
    for (const Json& item : items) {
        HM_TRY_ASSIGN(Material material, read_material(source, item, textures));
        materials.push_back(std::move(material));
    }
    return materials;
}

}  // namespace hm::gltf
