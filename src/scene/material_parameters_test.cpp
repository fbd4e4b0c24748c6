// The list of material parameters: derived tables are consistent, and docs/materials.md matches it.
#include "scene/material_parameters.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

namespace hm {
namespace {

std::string range_text(const MaterialFactor& f) {
    if (f.low == -kNoLimit) return "any";
    if (f.high == kNoLimit) return fmt::format("at least {:g}", f.low);
    return fmt::format("{:g} to {:g}", f.low, f.high);
}

std::string name_text(std::string_view owner, std::string_view key) {
    return owner.empty() ? fmt::format("`{}`", key) : fmt::format("`{}` `{}`", owner, key);
}

std::string factor_line(const MaterialFactor& f) {
    const std::string start = f.start == kNoLimit ? "infinite" : fmt::format("{:g}", f.start);
    return fmt::format("| {} | {} | {} | {} | {} | {} |", name_text(f.owner, f.key), f.components,
                       start, range_text(f), f.animated ? "yes" : "no", f.meaning);
}

std::string texture_line(const MaterialTexture& t) {
    return fmt::format("| {} | {} | {} |", name_text(t.owner, t.key),
                       t.encoding == kEncodingSrgb ? "sRGB" : "linear", t.meaning);
}

TEST(MaterialParameters, DocsHaveTheTable) {
    const char* dir = std::getenv("HIMALAYA_SOURCE_DIR");
    ASSERT_NE(dir, nullptr);
    std::ifstream file(std::string(dir) + "/docs/materials.md");
    ASSERT_TRUE(file);
    std::set<std::string> lines;
    for (std::string line; std::getline(file, line);)
        lines.insert(line);
    for (const MaterialFactor& f : material_factors())
        EXPECT_TRUE(lines.contains(factor_line(f))) << factor_line(f);
    for (const MaterialTexture& t : material_textures())
        EXPECT_TRUE(lines.contains(texture_line(t))) << texture_line(t);
    // Two tables, each with a header row and a separator row.
    std::size_t rows = 0;
    for (const std::string& line : lines)
        rows += line.starts_with("| `") ? 1 : 0;
    EXPECT_EQ(rows, material_factors().size() + material_textures().size());
}

TEST(MaterialParameters, DefaultsLieInTheirRangesAndReachTheirMembers) {
    Material material;
    for (const MaterialFactor& f : material_factors()) {
        SCOPED_TRACE(f.key);
        EXPECT_EQ(find_material_factor(f.value), &f);
        EXPECT_GE(f.start, f.low);
        EXPECT_LE(f.start, f.high);
        const std::span<float> numbers = material_floats(material, f.value);
        ASSERT_EQ(numbers.size(), f.components);
        for (float& number : numbers) {
            EXPECT_EQ(number, f.start);
            number = 7;
        }
    }
    EXPECT_EQ(material.base_color, vec4(7));
    EXPECT_EQ(material.emissive(), vec3(49));
    EXPECT_EQ(material.normal_scale, 7.0f);
    EXPECT_EQ(find_material_factor(AnimatedValue::yfov), nullptr);
    EXPECT_TRUE(material_floats(material, AnimatedValue::yfov).empty());
}

TEST(MaterialParameters, AnyChangeOfAnExtensionMakesAMaterialExtended) {
    EXPECT_FALSE(is_extended(Material{}));
    for (const MaterialFactor& f : material_factors()) {
        Material material;
        material_floats(material, f.value)[0] += 0.25f;
        if (f.start == kNoLimit) continue;
        EXPECT_EQ(is_extended(material), f.extended) << f.key;
    }
    Material textured;
    textured.sheen_color_texture.image = 0;
    EXPECT_TRUE(is_extended(textured));
    Material glossy;
    glossy.specular_glossiness = true;
    EXPECT_TRUE(is_extended(glossy));
}

TEST(MaterialParameters, PointersLeadIntoExtensions) {
    EXPECT_EQ(pointer_in_material("", "alphaCutoff"), "/alphaCutoff");
    EXPECT_EQ(pointer_in_material("normalTexture", "scale"), "/normalTexture/scale");
    EXPECT_EQ(pointer_in_material("KHR_materials_emissive_strength", "emissiveStrength"),
              "/extensions/KHR_materials_emissive_strength/emissiveStrength");
    EXPECT_TRUE(has_material_parameters("KHR_materials_emissive_strength"));
    EXPECT_EQ(pointer_in_material("KHR_materials_clearcoat/clearcoatNormalTexture", "scale"),
              "/extensions/KHR_materials_clearcoat/clearcoatNormalTexture/scale");
    EXPECT_TRUE(has_material_parameters("KHR_materials_sheen"));
    EXPECT_FALSE(has_material_parameters("KHR_materials_wax"));
    EXPECT_FALSE(has_material_parameters("pbrMetallicRoughness"));
}

}  // namespace
}  // namespace hm
