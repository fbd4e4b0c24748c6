// Every table that shading reads, listed once for C++ and GLSL. Members, uniform and storage blocks,
// descriptor set layouts, uploads and the tests of the layout are expansions of this list: to add a
// table, add a line here and fill its data.
//
//   HM_FRAME_VALUE(Type, name)                      one value for all pixels of a picture
//   HM_SCENE_TABLE(number, Type, name)              of a scene: a vector in SceneTables (scene/flatten.h)
//   HM_CONSTANT_TABLE(number, Type, name, rows)     always the same: ShadingTables (tables/tables.h)
//   HM_PICTURE_TABLE(number, Type, name, rows)      set with every picture: RenderJob (film/renderer.h)
//
// Define what you need of these, then include this file, which undefines them. A table whose macro is
// not defined expands to HM_TABLE(number, Type, name) if that is, otherwise to nothing. Numbers count
// from 0 in this order (checked in gpu/layouts.cpp); each user adds its first binding.
#ifndef HM_TABLE
#define HM_TABLE(number, Type, name)
#endif
#ifndef HM_FRAME_VALUE
#define HM_FRAME_VALUE(Type, name)
#endif
#ifndef HM_SCENE_TABLE
#define HM_SCENE_TABLE(number, Type, name) HM_TABLE(number, Type, name)
#endif
#ifndef HM_CONSTANT_TABLE
#define HM_CONSTANT_TABLE(number, Type, name, rows) HM_TABLE(number, Type, name)
#endif
#ifndef HM_PICTURE_TABLE
#define HM_PICTURE_TABLE(number, Type, name, rows) HM_TABLE(number, Type, name)
#endif

HM_FRAME_VALUE(RenderParams, params)
HM_FRAME_VALUE(CameraData, camera)
HM_FRAME_VALUE(EnvironmentData, environment)

HM_SCENE_TABLE(0, MaterialData, materials)  // the last one is glTF's default material
HM_SCENE_TABLE(1, TextureUse, texture_uses)
HM_SCENE_TABLE(2, GeometryData, geometries)
HM_SCENE_TABLE(3, InstanceData, instances)
HM_SCENE_TABLE(4, LightData, lights)
HM_SCENE_TABLE(5, AliasEntry, light_alias)
HM_SCENE_TABLE(6, EmitterTriangle, emitters)
HM_SCENE_TABLE(7, AliasEntry, emitter_alias)
HM_SCENE_TABLE(8, vec4, environment_texels)  // row 0 at the top
HM_SCENE_TABLE(9, AliasEntry, environment_alias)
HM_SCENE_TABLE(10, ExtendedMaterialData, extended_materials)

HM_CONSTANT_TABLE(11, uint, sobol_directions, 128 * 32)
HM_CONSTANT_TABLE(12, uvec4, sobol_nibbles, 8 * 16)
HM_CONSTANT_TABLE(13, uint, blue_noise, 128 * 128)
HM_CONSTANT_TABLE(14, vec2, albedo_table, kAlbedoRows * kAlbedoColumns)
HM_CONSTANT_TABLE(15, vec2, albedo_average, kAlbedoRows)
HM_CONSTANT_TABLE(16, float, sheen_albedo, kSheenRows * kSheenColumns)
HM_CONSTANT_TABLE(17, vec2, glass_albedo, 2 * kGlassIndices * kGlassRows * kGlassColumns)
HM_CONSTANT_TABLE(18, vec2, anisotropic_albedo,
                  kAnisotropyStrengths * kAnisotropyRows * kAnisotropyAzimuths * kAnisotropyColumns)

HM_PICTURE_TABLE(19, float, filter_table, 257)

#undef HM_TABLE
#undef HM_FRAME_VALUE
#undef HM_SCENE_TABLE
#undef HM_CONSTANT_TABLE
#undef HM_PICTURE_TABLE
