// Materials, texture slots, samplers and KHR_texture_transform.
#include <fmt/format.h>

#include <cmath>

#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

// The document with one texture and one material, used by the triangle.
Overrides material(const std::string& json) {
    return {{"materials", "[" + json + "]"},
            {"meshes", R"([{"primitives":[{"material":0,
                "attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":2}}]}])"},
            {"textures", R"([{"source":0,"sampler":0}])"},
            {"samplers", R"([{"wrapS":33071,"wrapT":33648,"magFilter":9728,"minFilter":9987}])"},
            {"images", fmt::format(R"([{{"uri":"data:image/png;base64,{}"}}])", kPng1)}};
}

Overrides with(Overrides overrides, const std::string& key, const std::string& value) {
    overrides[key] = value;
    return overrides;
}

Material load_material(const std::string& json) {
    const Loaded loaded = load_text(document(material(json)));
    EXPECT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_TRUE(loaded.diagnostics.warnings().empty())
        << loaded.diagnostics.warnings().front().line();
    return loaded.scene ? loaded.scene->materials.at(0) : Material();
}

TEST(Materials, Defaults) {
    const Material m = load_material("{}");
    EXPECT_EQ(m.base_color, vec4(1));
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.roughness, 1.0f);
    EXPECT_EQ(m.emissive(), vec3(0));
    EXPECT_EQ(m.normal_scale, 1.0f);
    EXPECT_EQ(m.occlusion_strength, 1.0f);
    EXPECT_EQ(m.specular_weight, 1.0f);
    EXPECT_EQ(m.alpha_cutoff, 0.5f);
    EXPECT_EQ(m.alpha_mode, kAlphaOpaque);
    EXPECT_FALSE(m.double_sided || m.unlit);
    EXPECT_EQ(m.base_color_texture.image, kUnset);
}

TEST(Materials, EveryProperty) {
    const Material m = load_material(R"({"name":"paint","pbrMetallicRoughness":{
        "baseColorFactor":[0.1,0.2,0.3,0.4],"metallicFactor":0.5,"roughnessFactor":0.25,
        "baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":0,"texCoord":1}},
        "emissiveFactor":[0.5,1,0],"emissiveTexture":{"index":0},
        "normalTexture":{"index":0,"scale":-2},"occlusionTexture":{"index":0,"strength":0.75},
        "alphaMode":"MASK","alphaCutoff":0.125,"doubleSided":true,"extensions":{
        "KHR_materials_emissive_strength":{"emissiveStrength":8},"KHR_materials_unlit":{}}})");
    EXPECT_EQ(m.name, "paint");
    EXPECT_EQ(m.base_color, vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.metallic, 0.5f);
    EXPECT_EQ(m.roughness, 0.25f);
    EXPECT_EQ(m.emissive(), vec3(4, 8, 0));
    EXPECT_EQ(m.normal_scale, -2.0f);
    EXPECT_EQ(m.occlusion_strength, 0.75f);
    EXPECT_EQ(m.alpha_mode, kAlphaMask);
    EXPECT_EQ(m.alpha_cutoff, 0.125f);
    EXPECT_TRUE(m.double_sided && m.unlit);
    for (const TextureSlot& slot : {m.base_color_texture, m.metallic_roughness_texture,
                                    m.normal_texture, m.occlusion_texture, m.emissive_texture}) {
        EXPECT_EQ(slot.image, 0);
        EXPECT_EQ(slot.wrap_u, kWrapClamp);
        EXPECT_EQ(slot.wrap_v, kWrapMirror);
        EXPECT_EQ(slot.filter_mode, kFilterNearest);
        EXPECT_EQ(slot.uv_row_u, vec3(1, 0, 0));
        EXPECT_EQ(slot.uv_row_v, vec3(0, 1, 0));
    }
    EXPECT_EQ(m.base_color_texture.uv_set, 0u);
    EXPECT_EQ(m.metallic_roughness_texture.uv_set, 1u);
    EXPECT_EQ(load_material(R"({"alphaMode":"BLEND"})").alpha_mode, kAlphaBlend);
    EXPECT_EQ(load_material(R"({"alphaMode":"OPAQUE"})").alpha_mode, kAlphaOpaque);
}

TEST(Materials, SamplerDefaults) {
    const Overrides base = material(R"({"emissiveTexture":{"index":0}})");
    for (const Overrides& overrides :
         {with(base, "samplers", "[{}]"), with(base, "textures", R"([{"source":0}])"),
          with(base, "samplers", R"([{"wrapS":10497,"wrapT":10497,"magFilter":9729}])")}) {
        const Loaded loaded = load_text(document(overrides));
        ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
        const TextureSlot& slot = loaded.scene->materials[0].emissive_texture;
        EXPECT_EQ(slot.wrap_u, kWrapRepeat);
        EXPECT_EQ(slot.wrap_v, kWrapRepeat);
        EXPECT_EQ(slot.filter_mode, kFilterLinear);
    }
}

vec2 transformed(const std::string& transform, vec2 uv) {
    const TextureSlot slot =
        load_material(
            fmt::format(
                R"({{"emissiveTexture":{{"index":0,"extensions":{{"KHR_texture_transform":{}}}}}}})",
                transform))
            .emissive_texture;
    return vec2(dot(slot.uv_row_u, vec3(uv, 1)), dot(slot.uv_row_v, vec3(uv, 1)));
}

void expect_near(vec2 a, vec2 b) {
    EXPECT_NEAR(double(a.x), double(b.x), 1e-6);
    EXPECT_NEAR(double(a.y), double(b.y), 1e-6);
}

TEST(TextureTransform, ExamplesOfTheExtension) {
    // "Only the lower left quadrant of the image, rotated clockwise 90 degrees": v grows downwards,
    // so that is u in 0..0.5 and v in 0.5..1.
    const std::string quadrant = R"({"offset":[0,1],"rotation":1.57079632679,"scale":[0.5,0.5]})";
    expect_near(transformed(quadrant, {0, 0}), {0, 1});
    expect_near(transformed(quadrant, {1, 0}), {0, 0.5f});
    expect_near(transformed(quadrant, {0, 1}), {0.5f, 1});
    expect_near(transformed(quadrant, {1, 1}), {0.5f, 0.5f});
    // "Inverts the T axis".
    const std::string inverted = R"({"offset":[0,1],"scale":[1,-1]})";
    expect_near(transformed(inverted, {0.25f, 0.25f}), {0.25f, 0.75f});
}

TEST(TextureTransform, ScaleThenRotateThenMove) {
    const double angle = 0.3, su = 2, sv = 3, tu = 0.1, tv = 0.2, u = 0.7, v = 0.4;
    const double x = su * u, y = sv * v;
    const vec2 expected(float(std::cos(angle) * x + std::sin(angle) * y + tu),
                        float(-std::sin(angle) * x + std::cos(angle) * y + tv));
    expect_near(
        transformed(R"({"offset":[0.1,0.2],"rotation":0.3,"scale":[2,3]})", {float(u), float(v)}),
        expected);
    expect_near(transformed("{}", {0.3f, 0.6f}), {0.3f, 0.6f});
}

TEST(TextureTransform, OverridesTheSet) {
    const Material m = load_material(R"({"emissiveTexture":{"index":0,"texCoord":0,
        "extensions":{"KHR_texture_transform":{"texCoord":1}}}})");
    EXPECT_EQ(m.emissive_texture.uv_set, 1u);
}

TEST(Materials, ClampsWithAWarning) {
    const Loaded loaded = load_text(document(material(R"({"pbrMetallicRoughness":{
        "baseColorFactor":[2,-1,0.5,1],"metallicFactor":1.5,"roughnessFactor":-0.5},
        "emissiveFactor":[3,0,0],"occlusionTexture":{"index":0,"strength":7},"alphaCutoff":-1})")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    const Material& m = loaded.scene->materials[0];
    EXPECT_EQ(m.base_color, vec4(1, 0, 0.5f, 1));
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.roughness, 0.0f);
    EXPECT_EQ(m.emissive(), vec3(1, 0, 0));
    EXPECT_EQ(m.occlusion_strength, 1.0f);
    EXPECT_EQ(m.alpha_cutoff, 0.0f);
    // One warning for all values clamped to 0..1, with the first pointer, and one for the cutoff.
    EXPECT_EQ(loaded.warned("/materials/0/pbrMetallicRoughness/baseColorFactor", "clamped"), 6u);
    EXPECT_EQ(loaded.warned("/materials/0/alphaCutoff", "below 0, clamped"), 1u);
}

TEST(Materials, MissingCoordinatesAreWarnedOf) {
    const Loaded far =
        load_text(document(material(R"({"emissiveTexture":{"index":0,"texCoord":2}})")));
    ASSERT_TRUE(far.scene);
    EXPECT_EQ(far.scene->materials[0].emissive_texture.uv_set, 0u);
    EXPECT_EQ(far.warned("/materials/0/emissiveTexture", "beyond TEXCOORD_1"), 1u);

    const Loaded none = load_text(document(
        with(material(R"({"emissiveTexture":{"index":0,"texCoord":1}})"), "meshes",
             R"([{"primitives":[{"material":0,"attributes":{"POSITION":0,"TEXCOORD_0":2}}]}])")));
    ASSERT_TRUE(none.scene);
    EXPECT_EQ(none.warned("/meshes/0/primitives/0",
                          "texture coordinates that the material uses are missing"),
              1u);
}

TEST(Materials, Refusals) {
    const Overrides textured = material(R"({"emissiveTexture":{"index":0}})");
    expect_refused({
        {"emits darkness", material(R"({"emissiveFactor":[0,-0.1,0]})"),
         "/materials/0/emissiveFactor", "negative"},
        {"two components", material(R"({"emissiveFactor":[0,1]})"), "/materials/0/emissiveFactor",
         "expected 3 numbers, found 2"},
        {"a word among numbers", material(R"({"emissiveFactor":[0,1,"x"]})"),
         "/materials/0/emissiveFactor/2", "expected a number, found a string"},
        {"negative strength",
         material(R"({"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":-1}}})"),
         "/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", "negative"},
        {"too large for a float", material(R"({"pbrMetallicRoughness":{"metallicFactor":1e39}})"),
         "/materials/0/pbrMetallicRoughness/metallicFactor", "32-bit float"},
        {"unknown mode", material(R"({"alphaMode":"GLASS"})"), "/materials/0/alphaMode",
         "\"GLASS\" is not an alpha mode"},
        {"flag as number", material(R"({"doubleSided":1})"), "/materials/0/doubleSided",
         "expected a boolean, found a number"},
        {"no index", material(R"({"normalTexture":{}})"), "/materials/0/normalTexture/index",
         "is required"},
        {"no such texture", material(R"({"normalTexture":{"index":1}})"),
         "/materials/0/normalTexture/index", "past the end of the 1 textures"},
        {"texture is a number", material(R"({"normalTexture":0})"), "/materials/0/normalTexture",
         "expected an object"},
        {"extensions is a list", material(R"({"extensions":[]})"), "/materials/0/extensions",
         "expected an object"},
        {"no such image", with(textured, "textures", R"([{"source":1}])"), "/textures/0/source",
         "past the end"},
        {"no such sampler", with(textured, "textures", R"([{"source":0,"sampler":1}])"),
         "/textures/0/sampler", "past the end"},
        {"unknown wrap", with(textured, "samplers", R"([{"wrapT":10496}])"), "/samplers/0/wrapT",
         "not a wrapping mode"},
        {"unknown filter", with(textured, "samplers", R"([{"magFilter":9987}])"),
         "/samplers/0/magFilter", "not a filter"},
        {"unknown minification", with(textured, "samplers", R"([{"minFilter":1}])"),
         "/samplers/0/minFilter", "not a filter"},
        {"an extension's image only",
         with(textured, "textures", R"([{"extensions":{"EXT_texture_webp":{"source":0}}}])"),
         "/textures/0", "EXT_texture_webp", ErrorKind::unsupported},
    });
    const Loaded bare = load_text(document(with(textured, "textures", "[{}]")));
    ASSERT_TRUE(bare.scene);
    EXPECT_EQ(bare.warned("/textures/0", "without an image"), 1u);
    EXPECT_EQ(bare.scene->materials[0].emissive_texture.image, kUnset);
}

}  // namespace
}  // namespace hm::gltf_test
