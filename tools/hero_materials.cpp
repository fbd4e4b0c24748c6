#include "hero_materials.h"

#include <fmt/format.h>

namespace hm {
namespace {

constexpr int kNoTexture = -1;

std::string metallic_roughness(glm::vec4 color, float metallic, float roughness, int color_texture,
                               int roughness_texture = kNoTexture) {
    std::string text = fmt::format(
        "\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{},{},{},{}],\"metallicFactor\":{},"
        "\"roughnessFactor\":{}",
        color.x, color.y, color.z, color.w, metallic, roughness);
    if (color_texture != kNoTexture)
        text += fmt::format(",\"baseColorTexture\":{{\"index\":{}}}", color_texture);
    if (roughness_texture != kNoTexture)
        text += fmt::format(",\"metallicRoughnessTexture\":{{\"index\":{}}}", roughness_texture);
    return text + "}";
}

std::string with_normals(int texture, float scale) {
    return fmt::format(",\"normalTexture\":{{\"index\":{},\"scale\":{}}}", texture, scale);
}

const char* const kTwoSided = ",\"doubleSided\":true";
const char* const kCutOut = ",\"doubleSided\":true,\"alphaMode\":\"MASK\",\"alphaCutoff\":0.5";
const char* const kBlended = ",\"doubleSided\":true,\"alphaMode\":\"BLEND\"";

}  // namespace

HeroMaterials add_hero_materials(GltfWriter& writer, const HeroTextures& t, int terrain_texture) {
    HeroMaterials m{};
    const auto plain = [&](const char* name, glm::vec3 color, float metallic, float roughness,
                           const std::string& more = "") {
        return writer.add_material(
            name, metallic_roughness(glm::vec4(color, 1), metallic, roughness, kNoTexture) + more);
    };
    const auto textured = [&](const char* name, glm::vec3 color, float roughness, int texture,
                              const std::string& more = "") {
        return writer.add_material(
            name, metallic_roughness(glm::vec4(color, 1), 0, roughness, texture) + more);
    };
    m.slab = writer.add_material(
        "slab", metallic_roughness({1, 1, 1, 1}, 1, 1, t.slab_color, t.slab_roughness) +
                    with_normals(t.slab_normal, 1));
    m.stone = textured("stone", {1, 1, 1}, 0.85f, t.rock_color, with_normals(t.rock_normal, 0.9f));
    m.warm_stone = textured("warm stone", {1, 0.86f, 0.70f}, 0.9f, t.rock_color,
                            with_normals(t.rock_normal, 0.9f));
    m.plaster =
        textured("plaster", {1, 1, 1}, 0.9f, t.plaster_color, with_normals(t.rock_normal, 0.22f));
    m.ochre = textured("ochre", {0.55f, 0.13f, 0.07f}, 0.85f, t.plaster_color,
                       with_normals(t.rock_normal, 0.3f));

    m.gold = plain("gold", {1.0f, 0.766f, 0.336f}, 1, 0.24f);
    m.copper =
        plain("copper", {0.93f, 0.50f, 0.34f}, 1, 0.19f, with_normals(t.hammered_normal, 0.8f));
    m.brass = plain("brass", {0.90f, 0.74f, 0.40f}, 1, 0.22f);
    m.celadon = plain("celadon", {0.40f, 0.56f, 0.47f}, 0, 0.07f);
    m.lacquer = plain("lacquer", {0.30f, 0.026f, 0.018f}, 0, 0.16f);
    m.cushion = plain("cushion", {0.36f, 0.10f, 0.22f}, 0, 0.9f);
    m.bead = plain("bead", {0.17f, 0.055f, 0.025f}, 0, 0.28f);
    m.wax = plain("wax", {0.80f, 0.72f, 0.55f}, 0, 0.5f);
    m.rope = plain("rope", {0.32f, 0.27f, 0.20f}, 0, 0.95f);
    m.bark = plain("bark", {0.12f, 0.085f, 0.06f}, 0, 0.9f);
    m.blossom = plain("blossom", {0.74f, 0.06f, 0.16f}, 0, 0.6f, kTwoSided);
    m.leaf = textured("leaf", {1, 1, 1}, 0.42f, t.leaf_color, kCutOut);
    m.grass = plain("grass", {0.20f, 0.19f, 0.055f}, 0, 0.7f, kTwoSided);
    m.conifer = plain("conifer", {0.030f, 0.050f, 0.026f}, 0, 0.9f, kTwoSided);
    m.terrain = textured("terrain", {1, 1, 1}, 0.8f, terrain_texture);

    m.scarf = writer.add_material(
        "scarf", metallic_roughness({1, 1, 1, 1}, 0, 0.45f, t.scarf_color) + kBlended);
    m.glass = writer.add_material(
        "glass", metallic_roughness({0.75f, 0.82f, 0.80f, 0.14f}, 0, 0.04f, kNoTexture) + kBlended);
    m.mist = writer.add_material("mist",
                                 metallic_roughness({1, 1, 1, 1}, 0, 1, t.mist_color) + kBlended);
    m.flame = plain("flame", {0, 0, 0}, 0, 1,
                    ",\"emissiveFactor\":[1,0.50,0.14],\"extensions\":"
                    "{\"KHR_materials_emissive_strength\":{\"emissiveStrength\":160}}");
    const glm::vec3 dyes[5] = {{0.05f, 0.13f, 0.46f},
                               {0.86f, 0.84f, 0.80f},
                               {0.56f, 0.035f, 0.03f},
                               {0.045f, 0.26f, 0.07f},
                               {0.86f, 0.52f, 0.045f}};
    for (int i = 0; i < 5; ++i)
        m.flags[i] = textured("flag", dyes[i], 0.85f, t.flag_color, kCutOut);
    return m;
}

}  // namespace hm
