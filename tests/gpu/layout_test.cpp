// The structs that a GPU reads are laid out there as in C++: the offsets, strides and sizes that
// the GLSL compiler wrote into the SPIR-V of layout.comp, against offsetof and sizeof.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "gpu/spirv_layout.h"
#include "shaders/layout_comp.h"
#include "shading/structs.h"

namespace hm {

namespace {

struct Expected {
    std::size_t size;
    std::map<std::string, std::size_t> offsets;
};

#define HM_MEMBER(Struct, member) \
    { #member, offsetof(Struct, member) }

const std::map<std::string, Expected> kExpected = {
    {"MaterialData",
     {sizeof(MaterialData),
      {HM_MEMBER(MaterialData, base_color_factor), HM_MEMBER(MaterialData, emissive_factor),
       HM_MEMBER(MaterialData, specular_weight), HM_MEMBER(MaterialData, metallic_factor),
       HM_MEMBER(MaterialData, roughness_factor), HM_MEMBER(MaterialData, normal_scale),
       HM_MEMBER(MaterialData, occlusion_strength), HM_MEMBER(MaterialData, base_color_texture),
       HM_MEMBER(MaterialData, emissive_texture),
       HM_MEMBER(MaterialData, metallic_roughness_texture), HM_MEMBER(MaterialData, normal_texture),
       HM_MEMBER(MaterialData, occlusion_texture), HM_MEMBER(MaterialData, alpha_cutoff),
       HM_MEMBER(MaterialData, alpha_mode), HM_MEMBER(MaterialData, flags)}}},
    {"TextureUse",
     {sizeof(TextureUse),
      {HM_MEMBER(TextureUse, image), HM_MEMBER(TextureUse, wrap_u), HM_MEMBER(TextureUse, wrap_v),
       HM_MEMBER(TextureUse, filter_mode), HM_MEMBER(TextureUse, uv_set),
       HM_MEMBER(TextureUse, uv_row_u), HM_MEMBER(TextureUse, uv_row_v)}}},
    {"Vertex",
     {sizeof(Vertex),
      {HM_MEMBER(Vertex, position), HM_MEMBER(Vertex, normal), HM_MEMBER(Vertex, tangent),
       HM_MEMBER(Vertex, uv0)}}},
    {"VertexExtra",
     {sizeof(VertexExtra), {HM_MEMBER(VertexExtra, uv1), HM_MEMBER(VertexExtra, color)}}},
    {"GeometryData",
     {sizeof(GeometryData),
      {HM_MEMBER(GeometryData, material), HM_MEMBER(GeometryData, flags),
       HM_MEMBER(GeometryData, emitter_offset), HM_MEMBER(GeometryData, triangle_count)}}},
    {"InstanceData",
     {sizeof(InstanceData),
      {HM_MEMBER(InstanceData, object_to_world), HM_MEMBER(InstanceData, world_to_object),
       HM_MEMBER(InstanceData, first_geometry), HM_MEMBER(InstanceData, first_emitter),
       HM_MEMBER(InstanceData, flags), HM_MEMBER(InstanceData, mesh)}}},
    {"LightData",
     {sizeof(LightData),
      {HM_MEMBER(LightData, position), HM_MEMBER(LightData, direction), HM_MEMBER(LightData, color),
       HM_MEMBER(LightData, range), HM_MEMBER(LightData, spot_scale),
       HM_MEMBER(LightData, spot_offset), HM_MEMBER(LightData, kind)}}},
    {"AliasEntry",
     {sizeof(AliasEntry),
      {HM_MEMBER(AliasEntry, threshold), HM_MEMBER(AliasEntry, alias),
       HM_MEMBER(AliasEntry, pdf_self), HM_MEMBER(AliasEntry, pdf_alias)}}},
    {"EmitterTriangle",
     {sizeof(EmitterTriangle),
      {HM_MEMBER(EmitterTriangle, p0), HM_MEMBER(EmitterTriangle, p1),
       HM_MEMBER(EmitterTriangle, p2), HM_MEMBER(EmitterTriangle, instance),
       HM_MEMBER(EmitterTriangle, geometry), HM_MEMBER(EmitterTriangle, primitive)}}},
    {"CameraData",
     {sizeof(CameraData),
      {HM_MEMBER(CameraData, origin), HM_MEMBER(CameraData, right), HM_MEMBER(CameraData, up),
       HM_MEMBER(CameraData, forward), HM_MEMBER(CameraData, half_width),
       HM_MEMBER(CameraData, half_height), HM_MEMBER(CameraData, lens_radius),
       HM_MEMBER(CameraData, focus_distance), HM_MEMBER(CameraData, kind)}}},
    {"EnvironmentData",
     {sizeof(EnvironmentData),
      {HM_MEMBER(EnvironmentData, width), HM_MEMBER(EnvironmentData, height),
       HM_MEMBER(EnvironmentData, u_offset), HM_MEMBER(EnvironmentData, intensity)}}},
    {"LightRange",
     {sizeof(LightRange),
      {HM_MEMBER(LightRange, begin), HM_MEMBER(LightRange, end), HM_MEMBER(LightRange, scale_int),
       HM_MEMBER(LightRange, scale_frac), HM_MEMBER(LightRange, pdf)}}},
    {"AovParams",
     {sizeof(AovParams),
      {HM_MEMBER(AovParams, light_groups), HM_MEMBER(AovParams, replicates),
       HM_MEMBER(AovParams, moves), HM_MEMBER(AovParams, next_camera)}}},
    {"RenderParams",
     {sizeof(RenderParams),
      {HM_MEMBER(RenderParams, width), HM_MEMBER(RenderParams, height),
       HM_MEMBER(RenderParams, seed), HM_MEMBER(RenderParams, sampler_kind),
       HM_MEMBER(RenderParams, max_bounces), HM_MEMBER(RenderParams, max_radiance),
       HM_MEMBER(RenderParams, strategy), HM_MEMBER(RenderParams, energy_compensation),
       HM_MEMBER(RenderParams, diffuse_kind), HM_MEMBER(RenderParams, background),
       HM_MEMBER(RenderParams, background_color), HM_MEMBER(RenderParams, filter_width),
       HM_MEMBER(RenderParams, environment_range), HM_MEMBER(RenderParams, punctual_range),
       HM_MEMBER(RenderParams, emitter_range), HM_MEMBER(RenderParams, light_count),
       HM_MEMBER(RenderParams, emitter_count)}}},
};

#undef HM_MEMBER

TEST(Layout, AgreesWithTheShaders) {
    const auto layouts = test::read_struct_layouts(shaders::layout_comp());
    for (const auto& [name, cpp] : kExpected) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(layouts.contains(name)) << "layout.comp does not use it";
        const test::StructLayout& glsl = layouts.at(name);
        EXPECT_EQ(glsl.array_stride, cpp.size);
        EXPECT_EQ(glsl.offsets, cpp.offsets);
        for (const auto& [member, stride] : glsl.matrix_strides)
            EXPECT_EQ(stride, sizeof(vec3)) << member;
    }
}

// A struct that somebody adds must enter the table above.
TEST(Layout, EveryStructIsCompared) {
    const char* root = std::getenv("HIMALAYA_SOURCE_DIR");
    std::ifstream file(std::string(root != nullptr ? root : ".") + "/src/shading/structs.h");
    std::stringstream text;
    text << file.rdbuf();
    const std::string source = text.str();
    const std::regex pattern(R"(\nstruct (\w+) \{)");
    std::size_t found = 0;
    for (std::sregex_iterator it(source.begin(), source.end(), pattern), end; it != end; ++it) {
        EXPECT_TRUE(kExpected.contains((*it)[1])) << (*it)[1];
        ++found;
    }
    EXPECT_EQ(found, kExpected.size());
}

}  // namespace

}  // namespace hm
