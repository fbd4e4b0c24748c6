#include "gltf/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

#include "base/text.h"
#include "gltf/specular_glossiness.h"
#include "gltf/textures.h"
#include "scene/choice_names.h"
#include "scene/material_parameters.h"

namespace hm::gltf {
namespace {

// Values outside the schema's range are clamped to it, with a warning.
float clamp_factor(Source& source, const Json& json, const MaterialFactor& factor, float value) {
    if (value < factor.low || value > factor.high)
        source.warn(json.pointer_of(factor.key),
                    factor.high == kNoLimit
                        ? fmt::format("below {}, clamped", factor.low)
                        : fmt::format("outside {} to {}, clamped", factor.low, factor.high));
    return std::clamp(value, factor.low, factor.high);
}

Result<void> read_factor(const Json& owner, const MaterialFactor& factor, Source& source,
                         Material& material) {
    const std::span<float> numbers = material_floats(material, factor.value);
    if (numbers.size() == 1) {
        HM_TRY_ASSIGN(numbers[0], owner.number_or(factor.key, factor.start));
    } else {
        HM_TRY(owner.numbers(factor.key, numbers));
    }
    for (float& number : numbers) {
        if (factor.below == BelowRange::refuse && number < factor.low)
            return owner.invalid(factor.key, "must not be negative");
        number = clamp_factor(source, owner, factor, number);
    }
    return {};
}

// The object that holds a parameter's key, if present: an object of the material, an extension, or
// an object within an extension ("EXTENSION/object").
Result<std::optional<Json>> find_owner(const Json& json, std::string_view owner) {
    if (owner.empty()) return json;
    if (!is_extension(owner)) return json.object(owner);
    const std::size_t slash = std::min(owner.find('/'), owner.size());
    HM_TRY_ASSIGN(const auto extension, extension_of(json, owner.substr(0, slash)));
    if (!extension || slash == owner.size()) return extension;
    return extension->object(owner.substr(slash + 1));
}

// Calls `read` for each parameter of a list whose owner is present.
template <class Parameter, class Read>
Result<void> read_each(const Json& json, std::span<const Parameter> parameters, const Read& read) {
    std::string_view name;
    std::optional<Json> owner = json;
    for (const Parameter& parameter : parameters) {
        if (parameter.owner != name) {
            name = parameter.owner;
            HM_TRY_ASSIGN(owner, find_owner(json, name));
        }
        if (owner) HM_TRY(read(*owner, parameter));
    }
    return {};
}

Result<std::uint32_t> read_alpha_mode(const Json& json) {
    HM_TRY_ASSIGN(const auto name, json.text("alphaMode"));
    if (!name) return kAlphaOpaque;
    const auto mode = find_choice(kAlphaModeNames, *name);
    if (!mode)
        return json.invalid("alphaMode", fmt::format("{} is not an alpha mode", excerpt(*name)));
    return *mode;
}

Result<Material> read_material(Source& source, const Json& json,
                               const std::vector<Texture>& textures) {
    Material material;
    HM_TRY_ASSIGN(material.name, name_of(json));
    HM_TRY(read_each(json, material_factors(), [&](const Json& owner, const MaterialFactor& f) {
        return read_factor(owner, f, source, material);
    }));
    HM_TRY(read_each(json, material_textures(),
                     [&](const Json& owner, const MaterialTexture& t) -> Result<void> {
                         HM_TRY_ASSIGN(const auto info, owner.object(t.key));
                         if (!info) return {};
                         HM_TRY_ASSIGN(material.*t.slot,
                                       read_texture_slot(*info, textures, source));
                         return {};
                     }));
    HM_TRY_ASSIGN(material.alpha_mode, read_alpha_mode(json));
    HM_TRY_ASSIGN(material.double_sided, json.flag("doubleSided"));
    HM_TRY_ASSIGN(const auto unlit, extension_of(json, "KHR_materials_unlit"));
    material.unlit = unlit.has_value();
    HM_TRY(read_specular_glossiness(json, textures, source, material));
    return material;
}

}  // namespace

Result<std::vector<Material>> read_materials(const Json& root, Source& source) {
    HM_TRY_ASSIGN(const std::vector<Texture> textures, read_textures(root));
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("materials"));
    std::vector<Material> materials;
    std::size_t volumes = 0;
    for (const Json& item : items) {
        HM_TRY_ASSIGN(Material material, read_material(source, item, textures));
        if (has_volume(material) && ++volumes > kMaxVolumes)
            return fail(
                ErrorKind::unsupported, source.file, item.pointer(),
                fmt::format("more than {} materials with a volume are not supported", kMaxVolumes));
        materials.push_back(std::move(material));
    }
    return materials;
}

}  // namespace hm::gltf
