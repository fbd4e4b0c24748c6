#include "gltf/textures.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "scene/choice_names.h"

namespace hm::gltf {
namespace {

constexpr std::array<std::string_view, 5> kImageExtensions{"KHR_texture_basisu", "EXT_texture_webp",
                                                           "EXT_texture_avif", "MSFT_texture_dds",
                                                           "EXT_texture_astc"};

Result<std::uint32_t> read_wrap(const Json& sampler, std::string_view key) {
    HM_TRY_ASSIGN(const auto value, sampler.integer(key));
    if (!value) return kWrapRepeat;
    const auto wrap = find_choice(kWrapCodes, *value);
    if (!wrap) return sampler.invalid(key, fmt::format("{} is not a wrapping mode", *value));
    return *wrap;
}

// Only magFilter is used: supersampling replaces minification filters.
Result<std::uint32_t> read_filter(const Json& sampler) {
    const auto is_mipmap = [](std::uint64_t code) { return code >= 9984 && code <= 9987; };
    HM_TRY_ASSIGN(const auto minify, sampler.integer("minFilter"));
    if (minify && !find_choice(kFilterCodes, *minify) && !is_mipmap(*minify))
        return sampler.invalid("minFilter", fmt::format("{} is not a filter", *minify));
    HM_TRY_ASSIGN(const auto magnify, sampler.integer("magFilter"));
    if (!magnify) return kFilterLinear;
    const auto filter = find_choice(kFilterCodes, *magnify);
    if (!filter) return sampler.invalid("magFilter", fmt::format("{} is not a filter", *magnify));
    return *filter;
}

Result<std::vector<TextureSlot>> read_samplers(const Json& root) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("samplers"));
    std::vector<TextureSlot> samplers;
    for (const Json& item : items) {
        TextureSlot slot;
        HM_TRY(name_of(item));
        HM_TRY_ASSIGN(slot.wrap_u, read_wrap(item, "wrapS"));
        HM_TRY_ASSIGN(slot.wrap_v, read_wrap(item, "wrapT"));
        HM_TRY_ASSIGN(slot.filter_mode, read_filter(item));
        samplers.push_back(slot);
    }
    return samplers;
}

// KHR_texture_transform: uv' = T R S uv. A positive angle rotates towards -v, as in the extension's
// examples (otherwise the first would leave the image's lower left quadrant); the GLSL code in the
// extension has the opposite sign, see KhronosGroup/glTF issue 1563.
Result<void> apply_transform(const Json& transform, TextureSlot& slot) {
    std::array<float, 2> offset{0, 0};
    std::array<float, 2> scale{1, 1};
    HM_TRY(transform.numbers("offset", offset));
    HM_TRY(transform.numbers("scale", scale));
    HM_TRY_ASSIGN(const float angle, transform.number_or("rotation", 0));
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    slot.uv_row_u = vec3(c * scale[0], s * scale[1], offset[0]);
    slot.uv_row_v = vec3(-s * scale[0], c * scale[1], offset[1]);
    return {};
}

}  // namespace

Result<std::vector<Texture>> read_textures(const Json& root) {
    HM_TRY_ASSIGN(const std::vector<TextureSlot> samplers, read_samplers(root));
    HM_TRY_ASSIGN(const std::vector<Json> images, root.objects("images"));
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("textures"));
    std::vector<Texture> textures;
    for (const Json& item : items) {
        Texture texture;
        HM_TRY(name_of(item));
        HM_TRY_ASSIGN(const auto sampler, item.index("sampler", samplers.size(), "samplers"));
        if (sampler) texture.slot = samplers[*sampler];
        HM_TRY_ASSIGN(const auto image, item.index("source", images.size(), "images"));
        if (image) {
            texture.slot.image = static_cast<int>(*image);
        } else {
            for (const std::string_view name : kImageExtensions) {
                HM_TRY_ASSIGN(const auto extension, extension_of(item, name));
                if (extension) texture.extension = name;
            }
        }
        textures.push_back(texture);
    }
    return textures;
}

Result<TextureSlot> read_texture_slot(const Json& info, const std::vector<Texture>& textures,
                                      Source& source) {
    HM_TRY_ASSIGN(const std::size_t index,
                  info.required("index", info.index("index", textures.size(), "textures")));
    const Texture& texture = textures[index];
    const std::string pointer = fmt::format("/textures/{}", index);
    if (!texture.extension.empty())
        return fail(
            ErrorKind::unsupported, source.file, pointer,
            fmt::format("its only image uses {}, which is not supported", texture.extension));
    TextureSlot slot = texture.slot;
    if (slot.image == kUnset) source.warn(pointer, "texture without an image is ignored");

    HM_TRY_ASSIGN(const auto own_set, info.integer("texCoord"));
    HM_TRY_ASSIGN(const auto transform, extension_of(info, "KHR_texture_transform"));
    std::uint64_t uv_set = own_set.value_or(0);
    if (transform) {
        HM_TRY(apply_transform(*transform, slot));
        HM_TRY_ASSIGN(const auto other_set, transform->integer("texCoord"));
        uv_set = other_set.value_or(uv_set);
    }
    if (uv_set > 1) {
        source.warn(info.pointer(),
                    "texture coordinates beyond TEXCOORD_1 are not supported; "
                    "TEXCOORD_0 is used");
        uv_set = 0;
    }
    slot.uv_set = static_cast<std::uint32_t>(uv_set);
    return slot;
}

}  // namespace hm::gltf
