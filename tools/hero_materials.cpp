#include "hero_materials.h"

namespace hm {
namespace {

constexpr glm::vec3 kWhite(1);

GltfMaterial plain(glm::vec3 color, float metallic, float roughness) {
    return {.color = glm::vec4(color, 1), .metallic = metallic, .roughness = roughness};
}

GltfMaterial textured(glm::vec3 color, float roughness, int texture) {
    GltfMaterial material = plain(color, 0, roughness);
    material.color_texture = texture;
    return material;
}

GltfMaterial with_normals(GltfMaterial material, int texture, float scale) {
    material.normal_texture = texture;
    material.normal_scale = scale;
    return material;
}

GltfMaterial two_sided(GltfMaterial material) {
    material.two_sided = true;
    return material;
}

GltfMaterial cut_out(GltfMaterial material) {
    material.alpha_mode = "MASK";
    return two_sided(material);
}

GltfMaterial blended(GltfMaterial material) {
    material.alpha_mode = "BLEND";
    return two_sided(material);
}

}  // namespace

HeroMaterials add_hero_materials(GltfWriter& writer, const HeroTextures& t, int terrain_texture) {
    HeroMaterials m{};
    const auto add = [&](const char* name, const GltfMaterial& material) {
        return writer.add_material(name, material);
    };
    GltfMaterial slab = plain(kWhite, 1, 1);
    slab.color_texture = t.slab_color;
    slab.roughness_texture = t.slab_roughness;
    m.slab = add("slab", with_normals(slab, t.slab_normal, 1));
    m.stone =
        add("stone", with_normals(textured(kWhite, 0.85f, t.rock_color), t.rock_normal, 0.9f));
    m.warm_stone = add("warm stone", with_normals(textured({1, 0.86f, 0.70f}, 0.9f, t.rock_color),
                                                  t.rock_normal, 0.9f));
    m.plaster =
        add("plaster", with_normals(textured(kWhite, 0.9f, t.plaster_color), t.rock_normal, 0.22f));
    m.ochre = add("ochre", with_normals(textured({0.55f, 0.13f, 0.07f}, 0.85f, t.plaster_color),
                                        t.rock_normal, 0.3f));

    m.gold = add("gold", plain({1.0f, 0.766f, 0.336f}, 1, 0.24f));
    m.copper = add("copper",
                   with_normals(plain({0.93f, 0.50f, 0.34f}, 1, 0.19f), t.hammered_normal, 0.8f));
    m.brass = add("brass", plain({0.90f, 0.74f, 0.40f}, 1, 0.22f));
    m.celadon = add("celadon", plain({0.40f, 0.56f, 0.47f}, 0, 0.07f));
    m.lacquer = add("lacquer", plain({0.30f, 0.026f, 0.018f}, 0, 0.16f));
    m.cushion = add("cushion", plain({0.36f, 0.10f, 0.22f}, 0, 0.9f));
    m.bead = add("bead", plain({0.17f, 0.055f, 0.025f}, 0, 0.28f));
    m.wax = add("wax", plain({0.80f, 0.72f, 0.55f}, 0, 0.5f));
    m.rope = add("rope", plain({0.32f, 0.27f, 0.20f}, 0, 0.95f));
    m.bark = add("bark", plain({0.12f, 0.085f, 0.06f}, 0, 0.9f));
    m.blossom = add("blossom", two_sided(plain({0.74f, 0.06f, 0.16f}, 0, 0.6f)));
    m.leaf = add("leaf", cut_out(textured(kWhite, 0.42f, t.leaf_color)));
    m.grass = add("grass", two_sided(plain({0.20f, 0.19f, 0.055f}, 0, 0.7f)));
    m.conifer = add("conifer", two_sided(plain({0.030f, 0.050f, 0.026f}, 0, 0.9f)));
    m.terrain = add("terrain", textured(kWhite, 0.8f, terrain_texture));

    m.scarf = add("scarf", blended(textured(kWhite, 0.45f, t.scarf_color)));
    GltfMaterial glass = plain({0.75f, 0.82f, 0.80f}, 0, 0.04f);
    glass.color.w = 0.14f;
    m.glass = add("glass", blended(glass));
    m.mist = add("mist", blended(textured(kWhite, 1, t.mist_color)));
    GltfMaterial flame = plain({0, 0, 0}, 0, 1);
    flame.emissive = {1, 0.5f, 0.14f};
    flame.emissive_strength = 160;
    m.flame = add("flame", flame);
    const glm::vec3 dyes[5] = {{0.05f, 0.13f, 0.46f},
                               {0.86f, 0.84f, 0.80f},
                               {0.56f, 0.035f, 0.03f},
                               {0.045f, 0.26f, 0.07f},
                               {0.86f, 0.52f, 0.045f}};
    for (int i = 0; i < 5; ++i)
        m.flags[i] = add("flag", cut_out(textured(dyes[i], 0.85f, t.flag_color)));
    return m;
}

}  // namespace hm
