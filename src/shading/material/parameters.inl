// The parameters of a material, each listed once. From here follow the members of Material
// (scene/scene.h), the glTF loader, flattening, the targets of KHR_animation_pointer, `info`, how
// shading reads the textures, and the table in docs/materials.md. C++ and GLSL at once. Define the
// macros that you need, then include this file, which undefines them.
//
// HM_FACTOR(owner, key, type, member, default, low, high, below, animated, table, meaning)
//   owner     the JSON object of the material that has the key: "" for the material itself, the name
//             of an object within it, or of an extension
//   type      float, vec3 or vec4
//   low, high the range; values outside are clamped with a warning
//   below     kClamp, or kRefuse for values below `low` that make the file invalid
//   animated  whether animating it changes a picture
//   table     how flattening puts it into MaterialData: a member and an assignment operator
//
// HM_TEXTURE(owner, key, slot, read, encoding, meaning)
//   slot      the member of Material (a TextureSlot) and of MaterialData (a texture use)
//   read      the shading function that looks the texture up
//   encoding  kEncoding* of its colour channels
#ifndef HM_FACTOR
#define HM_FACTOR(owner, key, type, member, start, low, high, below, animated, table, meaning)
#endif
#ifndef HM_TEXTURE
#define HM_TEXTURE(owner, key, slot, read, encoding, meaning)
#endif

HM_FACTOR("pbrMetallicRoughness", "baseColorFactor", vec4, base_color, 1.0f, 0.0f, 1.0f, kClamp, true,
          base_color_factor =, "linear colour and alpha")
HM_FACTOR("pbrMetallicRoughness", "metallicFactor", float, metallic, 1.0f, 0.0f, 1.0f, kClamp, true,
          metallic_factor =, "mix of dielectric (0) and metal (1)")
HM_FACTOR("pbrMetallicRoughness", "roughnessFactor", float, roughness, 1.0f, 0.0f, 1.0f, kClamp, true,
          roughness_factor =, "square root of GGX's alpha")
HM_FACTOR("", "emissiveFactor", vec3, emissive_factor, 0.0f, 0.0f, 1.0f, kRefuse, true,
          emissive_factor =, "emitted radiance, linear")
HM_FACTOR("KHR_materials_emissive_strength", "emissiveStrength", float, emissive_strength, 1.0f, 0.0f,
          kNoLimit, kRefuse, true, emissive_factor *=, "multiplies emissiveFactor, to nits")
HM_FACTOR("", "alphaCutoff", float, alpha_cutoff, 0.5f, 0.0f, kNoLimit, kClamp, true,
          alpha_cutoff =, "least alpha that MASK keeps")
HM_FACTOR("normalTexture", "scale", float, normal_scale, 1.0f, -kNoLimit, kNoLimit, kClamp, true,
          normal_scale =, "scales the x and y of the normal map")
HM_FACTOR("occlusionTexture", "strength", float, occlusion_strength, 1.0f, 0.0f, 1.0f, kClamp, false,
          occlusion_strength =, "ignored: occlusion is simulated")

HM_TEXTURE("pbrMetallicRoughness", "baseColorTexture", base_color_texture, read_base_color,
           kEncodingSrgb, "RGB colour, A alpha")
HM_TEXTURE("pbrMetallicRoughness", "metallicRoughnessTexture", metallic_roughness_texture,
           read_metallic_roughness, kEncodingLinear, "G roughness, B metallic")
HM_TEXTURE("", "normalTexture", normal_texture, read_normal, kEncodingLinear,
           "RGB tangent-space normal")
HM_TEXTURE("", "occlusionTexture", occlusion_texture, read_occlusion, kEncodingLinear,
           "ignored: occlusion is simulated")
HM_TEXTURE("", "emissiveTexture", emissive_texture, read_emissive, kEncodingSrgb,
           "RGB emitted radiance")

#undef HM_FACTOR
#undef HM_TEXTURE
