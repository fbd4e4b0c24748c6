#include <string_view>
#include <type_traits>
#include <utility>

#include "base/check.h"
#include "scene/flatten_parts.h"
#include "scene/material_parameters.h"

namespace hm {
namespace {

constexpr std::uint8_t kWhiteTexel[4] = {255, 255, 255, 255};

// MaterialData keeps every parameter in a member of the parameter's type, apart from those that
// multiply another one's, and has no other members than these and the three that add_material sets
// by name.
constexpr bool multiplies(std::string_view table) {
    return table.ends_with("*=");
}
#define HM_FACTOR(owner, key, type, member, start, low, high, below, animated, table, meaning) \
    static_assert(multiplies(#table) ||                                                        \
                  std::is_same_v<decltype(std::declval<MaterialData&>().table type{}), type&>);
#define HM_TEXTURE(owner, key, slot, read, encoding, meaning) \
    static_assert(std::is_same_v<decltype(MaterialData::slot), std::uint32_t>);
#define HM_EXTENDED_FACTOR(...)
#define HM_EXTENDED_TEXTURE(...)
#include "shading/material/parameters.inl"
constexpr std::size_t kBytesOfParameters =
#define HM_FACTOR(owner, key, type, member, start, low, high, below, animated, table, meaning) \
    (multiplies(#table) ? 0 : sizeof(type)) +
#define HM_TEXTURE(owner, key, slot, read, encoding, meaning) sizeof(MaterialData::slot) +
#define HM_EXTENDED_FACTOR(...)
#define HM_EXTENDED_TEXTURE(...)
#include "shading/material/parameters.inl"
    0;
static_assert(sizeof(MaterialData) == kBytesOfParameters + sizeof(MaterialData::specular_weight) +
                                          sizeof(MaterialData::alpha_mode) +
                                          sizeof(MaterialData::flags));

std::uint32_t add_texture_use(FlatScene& flat, const TextureSlot& slot) {
    if (slot.image == kUnset) return 0;
    flat.texture_uses.push_back({std::uint32_t(slot.image) + 1, slot.wrap_u, slot.wrap_v,
                                 slot.filter_mode, slot.uv_set, slot.uv_row_u, slot.uv_row_v});
    return std::uint32_t(flat.texture_uses.size()) - 1;
}

void add_extended_material(FlatScene& flat, const Material& m) {
    ExtendedMaterialData data{};
#define HM_EXTENDED_FACTOR(owner, key, type, member, start, low, high, below, animated, meaning) \
    data.member = m.member;
#define HM_EXTENDED_TEXTURE(owner, key, slot, read, encoding, meaning) \
    data.slot = add_texture_use(flat, m.slot);
#include "shading/material/parameters.inl"
    flat.extended_materials.push_back(data);
}

// 1 + each material's row in extended_materials, 0 where it needs none. Volumes have the first
// rows.
std::vector<std::uint32_t> add_extended_materials(FlatScene& flat, const Scene& scene) {
    std::vector<std::uint32_t> rows(scene.materials.size(), 0);
    for (const bool volumes : {true, false}) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Material& m = scene.materials[i];
            if (!is_extended(m) || has_volume(m) != volumes) continue;
            add_extended_material(flat, m);
            rows[i] = std::uint32_t(flat.extended_materials.size());
        }
        if (volumes)
            HM_CHECK(flat.extended_materials.size() <= kMaxVolumes, "more than {} volumes",
                     kMaxVolumes);
    }
    return rows;
}

void add_material(FlatScene& flat, const Material& m, std::uint32_t row) {
    MaterialData data{};
#define HM_FACTOR(owner, key, type, member, start, low, high, below, animated, table, meaning) \
    data.table m.member;
#define HM_TEXTURE(owner, key, slot, read, encoding, meaning) \
    data.slot = add_texture_use(flat, m.slot);
#define HM_EXTENDED_FACTOR(...)
#define HM_EXTENDED_TEXTURE(...)
#include "shading/material/parameters.inl"
    data.specular_weight = m.specular_weight;
    data.alpha_mode = m.alpha_mode;
    data.flags = row << kMaterialRowShift;
    if (m.double_sided) data.flags |= kMaterialDoubleSided;
    if (m.unlit) data.flags |= kMaterialUnlit;
    if (has_volume(m)) data.flags |= kMaterialVolume;
    if (m.specular_glossiness) data.flags |= kMaterialGlossy;
    flat.materials.push_back(data);
}

}  // namespace

void flatten_materials(const Scene& scene, FlatScene& flat) {
    flat.images.push_back({kWhiteTexel, 1, 1, std::uint32_t(PixelFormat::rgba8)});
    for (const TextureImage& image : scene.images)
        flat.images.push_back(
            {image.bytes().data(), image.width(), image.height(), std::uint32_t(image.format())});
    flat.texture_uses.push_back({0, 0, 0, 0, 0, vec3(1, 0, 0), vec3(0, 1, 0)});
    const std::vector<std::uint32_t> rows = add_extended_materials(flat, scene);
    for (std::size_t i = 0; i < rows.size(); ++i)
        add_material(flat, scene.materials[i], rows[i]);
    add_material(flat, Material{}, 0);
}

}  // namespace hm
