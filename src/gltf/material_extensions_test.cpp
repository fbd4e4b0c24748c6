// Extensions of materials: every entry of the list reaches its member, and specular-glossiness
// replaces metallic and roughness.
#include <fmt/format.h>

#include <algorithm>

#include "gltf/test_files.h"
#include "scene/material_parameters.h"

namespace hm::gltf_test {
namespace {

Overrides materials(const std::string& json) {
    return {{"materials", "[" + json + "]"},
            {"meshes", R"([{"primitives":[{"material":0,
                "attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":2}}]}])"},
            {"textures", R"([{"source":0}])"},
            {"images", fmt::format(R"([{{"uri":"data:image/png;base64,{}"}}])", kPng1)}};
}

Loaded load_material(const std::string& json) {
    return load_text(document(materials(json)));
}

// {"extensions":{"KHR_x":{"object":{"key":value}}}} for the owner "KHR_x/object".
std::string property(std::string_view owner, std::string_view key, const std::string& value) {
    std::string json = fmt::format(R"({{"{}":{}}})", key, value);
    const std::size_t slash = owner.find('/');
    // Objects within an extension are textures, which need an index.
    if (slash != owner.npos)
        json = fmt::format(R"({{"{}":{{"index":0,{}}})", owner.substr(slash + 1), json.substr(1));
    return fmt::format(R"({{"extensions":{{"{}":{}}}}})", owner.substr(0, slash), json);
}

std::string numbers(float value, std::size_t count) {
    if (count == 1) return fmt::format("{}", value);
    return fmt::format("[{}{}]", value, fmt::format(",{0},{0}", value));
}

TEST(MaterialExtensions, EveryFactorReachesItsMember) {
    for (const MaterialFactor& factor : material_factors()) {
        if (!factor.extended) continue;
        SCOPED_TRACE(factor.key);
        const float value = factor.low == 1 ? 1.75f : 0.25f;
        const Loaded loaded =
            load_material(property(factor.owner, factor.key, numbers(value, factor.components)));
        ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
        EXPECT_TRUE(loaded.diagnostics.warnings().empty());
        for (const float number : material_floats(loaded.scene->materials[0], factor.value))
            EXPECT_EQ(number, value);
    }
}

TEST(MaterialExtensions, EveryTextureReachesItsSlot) {
    std::size_t tried = 0;
    for (const MaterialTexture& texture : material_textures()) {
        if (!is_extension(texture.owner)) continue;
        SCOPED_TRACE(texture.key);
        const Loaded loaded =
            load_material(property(texture.owner, texture.key, R"({"index":0,"texCoord":1})"));
        ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
        const TextureSlot& slot = loaded.scene->materials[0].*texture.slot;
        EXPECT_EQ(slot.image, 0);
        EXPECT_EQ(slot.uv_set, 1u);
        EXPECT_TRUE(is_extended(loaded.scene->materials[0]));
        ++tried;
    }
    EXPECT_EQ(tried, 13u);
}

TEST(MaterialExtensions, OutOfRangeIsClampedOrRefused) {
    const Loaded clamped =
        load_material(R"({"extensions":{"KHR_materials_sheen":{"sheenColorFactor":[2,0.5,-1]}}})");
    ASSERT_TRUE(clamped.scene);
    EXPECT_EQ(clamped.scene->materials[0].sheen_color, vec3(1, 0.5f, 0));
    EXPECT_FALSE(clamped.diagnostics.warnings().empty());
    const Loaded refused =
        load_material(R"({"extensions":{"KHR_materials_volume":{"attenuationDistance":-1}}})");
    ASSERT_FALSE(refused.scene);
    EXPECT_NE(refused.scene.error().line().find(
                  "/materials/0/extensions/KHR_materials_volume/attenuationDistance"),
              std::string::npos)
        << refused.scene.error().line();
    EXPECT_FALSE(load_material(R"({"extensions":{"KHR_materials_ior":{"ior":"glass"}}})").scene);
    EXPECT_FALSE(load_material(R"({"extensions":{"KHR_materials_clearcoat":{
        "clearcoatTexture":{"index":1}}}})")
                     .scene);
}

TEST(MaterialExtensions, SpecularGlossinessReplacesMetallicRoughness) {
    const Loaded loaded = load_material(R"({"pbrMetallicRoughness":{"metallicFactor":1,
        "metallicRoughnessTexture":{"index":0}},"extensions":{
        "KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.5,0.25,0.125,0.75],
        "specularFactor":[0.1,0.2,0.3],"glossinessFactor":0.75,
        "specularGlossinessTexture":{"index":0}}}})");
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    const Material& m = loaded.scene->materials[0];
    EXPECT_TRUE(m.specular_glossiness);
    EXPECT_EQ(m.base_color, vec4(0.5f, 0.25f, 0.125f, 0.75f));
    EXPECT_EQ(m.specular_color, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.metallic, 0.0f);
    EXPECT_EQ(m.roughness, 0.25f);
    EXPECT_EQ(m.specular_color_texture.image, 0);
    EXPECT_EQ(m.metallic_roughness_texture.image, kUnset);
    EXPECT_EQ(m.base_color_texture.image, kUnset);
    const Loaded clamped = load_material(R"({"extensions":{
        "KHR_materials_pbrSpecularGlossiness":{"glossinessFactor":2,"specularFactor":[9,1,1]}}})");
    ASSERT_TRUE(clamped.scene);
    EXPECT_FALSE(clamped.diagnostics.warnings().empty());
    EXPECT_EQ(clamped.scene->materials[0].roughness, 0.0f);
}

}  // namespace
}  // namespace hm::gltf_test
