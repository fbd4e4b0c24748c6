#include "gltf/specular_glossiness.h"

#include <algorithm>
#include <span>

#include "scene/components.h"

namespace hm::gltf {
namespace {

Result<void> read_numbers(const Json& owner, std::string_view key, std::span<float> numbers,
                          Source& source) {
    std::fill(numbers.begin(), numbers.end(), 1.0f);
    HM_TRY(owner.numbers(key, numbers));
    for (float& number : numbers) {
        const float kept = std::clamp(number, 0.0f, 1.0f);
        if (kept != number) source.warn(owner.pointer_of(key), "outside 0 to 1, clamped");
        number = kept;
    }
    return {};
}

Result<TextureSlot> read_slot(const Json& owner, std::string_view key,
                              const std::vector<Texture>& textures, Source& source) {
    HM_TRY_ASSIGN(const auto info, owner.object(key));
    if (!info) return TextureSlot{};
    return read_texture_slot(*info, textures, source);
}

}  // namespace

Result<void> read_specular_glossiness(const Json& json, const std::vector<Texture>& textures,
                                      Source& source, Material& material) {
    HM_TRY_ASSIGN(const auto extension, extension_of(json, kSpecularGlossiness));
    if (!extension) return {};
    HM_TRY(read_numbers(*extension, "diffuseFactor", components(material.base_color), source));
    HM_TRY(read_numbers(*extension, "specularFactor", components(material.specular_color), source));
    HM_TRY_ASSIGN(float glossiness, extension->number_or("glossinessFactor", 1));
    if (glossiness < 0 || glossiness > 1)
        source.warn(extension->pointer_of("glossinessFactor"), "outside 0 to 1, clamped");
    glossiness = std::clamp(glossiness, 0.0f, 1.0f);
    HM_TRY_ASSIGN(material.base_color_texture,
                  read_slot(*extension, "diffuseTexture", textures, source));
    HM_TRY_ASSIGN(material.specular_color_texture,
                  read_slot(*extension, "specularGlossinessTexture", textures, source));
    material.metallic = 0;
    material.roughness = 1 - glossiness;
    material.metallic_roughness_texture = {};
    material.specular_glossiness = true;
    return {};
}

}  // namespace hm::gltf
