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
//
// HM_EXTENDED_FACTOR and HM_EXTENDED_TEXTURE are the same for extensions that add lobes or media. Their
// values are members of ExtendedMaterialData under the same names, so they have no column `table`;
// instead of `read` they have the member of ExtendedTexels (material/extended_textures.h). Where they are
// not defined, they count as HM_FACTOR and HM_TEXTURE. An owner may be a path: an object within an
// extension.
#ifndef HM_FACTOR
#define HM_FACTOR(owner, key, type, member, start, low, high, below, animated, table, meaning)
#endif
#ifndef HM_TEXTURE
#define HM_TEXTURE(owner, key, slot, read, encoding, meaning)
#endif

#ifndef HM_EXTENDED_FACTOR
#define HM_EXTENDED_FACTOR(owner, key, type, member, start, low, high, below, animated, meaning) \
    HM_FACTOR(owner, key, type, member, start, low, high, below, animated, member =, meaning)
#endif
#ifndef HM_EXTENDED_TEXTURE
#define HM_EXTENDED_TEXTURE(owner, key, slot, texel, encoding, meaning) \
    HM_TEXTURE(owner, key, slot, texel, encoding, meaning)
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

HM_EXTENDED_FACTOR("KHR_materials_specular", "specularFactor", float, specular, 1.0f, 0.0f, 1.0f,
                   kClamp, true, "strength of the dielectric's reflection")
HM_EXTENDED_FACTOR("KHR_materials_specular", "specularColorFactor", vec3, specular_color, 1.0f, 0.0f,
                   kNoLimit, kClamp, true, "colour of its reflection at normal incidence")
HM_EXTENDED_FACTOR("KHR_materials_ior", "ior", float, ior, 1.5f, 0.0f, kNoLimit, kClamp, true,
                   "index of refraction; 0: reflects everything")
HM_EXTENDED_FACTOR("KHR_materials_clearcoat", "clearcoatFactor", float, clearcoat, 0.0f, 0.0f, 1.0f,
                   kClamp, true, "strength of the coat")
HM_EXTENDED_FACTOR("KHR_materials_clearcoat", "clearcoatRoughnessFactor", float, clearcoat_roughness,
                   0.0f, 0.0f, 1.0f, kClamp, true, "square root of the coat's alpha")
HM_EXTENDED_FACTOR("KHR_materials_clearcoat/clearcoatNormalTexture", "scale", float,
                   clearcoat_normal_scale, 1.0f, -kNoLimit, kNoLimit, kClamp, true,
                   "scales the x and y of the coat's normal map")
HM_EXTENDED_FACTOR("KHR_materials_sheen", "sheenColorFactor", vec3, sheen_color, 0.0f, 0.0f, 1.0f,
                   kClamp, true, "colour of cloth fibres")
HM_EXTENDED_FACTOR("KHR_materials_sheen", "sheenRoughnessFactor", float, sheen_roughness, 0.0f, 0.0f,
                   1.0f, kClamp, true, "square root of the fibres' alpha")
HM_EXTENDED_FACTOR("KHR_materials_anisotropy", "anisotropyStrength", float, anisotropy, 0.0f, 0.0f,
                   1.0f, kClamp, true, "stretches the highlight")
HM_EXTENDED_FACTOR("KHR_materials_anisotropy", "anisotropyRotation", float, anisotropy_rotation, 0.0f,
                   -kNoLimit, kNoLimit, kClamp, true, "radians from the tangent, counter-clockwise")
HM_EXTENDED_FACTOR("KHR_materials_iridescence", "iridescenceFactor", float, iridescence, 0.0f, 0.0f,
                   1.0f, kClamp, true, "strength of the thin film")
HM_EXTENDED_FACTOR("KHR_materials_iridescence", "iridescenceIor", float, iridescence_ior, 1.3f, 1.0f,
                   kNoLimit, kClamp, true, "index of the film")
HM_EXTENDED_FACTOR("KHR_materials_iridescence", "iridescenceThicknessMinimum", float,
                   iridescence_thickness_minimum, 100.0f, 0.0f, kNoLimit, kClamp, true,
                   "nanometres where the texture is 0")
HM_EXTENDED_FACTOR("KHR_materials_iridescence", "iridescenceThicknessMaximum", float,
                   iridescence_thickness_maximum, 400.0f, 0.0f, kNoLimit, kClamp, true,
                   "nanometres where the texture is 1, or without one")
HM_EXTENDED_FACTOR("KHR_materials_transmission", "transmissionFactor", float, transmission, 0.0f, 0.0f,
                   1.0f, kClamp, true, "share of the diffuse base that is glass")
HM_EXTENDED_FACTOR("KHR_materials_volume", "thicknessFactor", float, thickness, 0.0f, 0.0f, kNoLimit,
                   kClamp, true, "above 0: the mesh bounds a volume; 0: thin walls")
HM_EXTENDED_FACTOR("KHR_materials_volume", "attenuationDistance", float, attenuation_distance, kNoLimit,
                   0.0f, kNoLimit, kRefuse, true, "metres after which white light has attenuationColor")
HM_EXTENDED_FACTOR("KHR_materials_volume", "attenuationColor", vec3, attenuation_color, 1.0f, 0.0f,
                   1.0f, kClamp, true, "what is left of white light there")
HM_EXTENDED_FACTOR("KHR_materials_dispersion", "dispersion", float, dispersion, 0.0f, 0.0f, kNoLimit,
                   kClamp, true, "20 / Abbe number")
HM_EXTENDED_FACTOR("KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", float,
                   diffuse_transmission, 0.0f, 0.0f, 1.0f, kClamp, true,
                   "share of diffuse light that passes through")
HM_EXTENDED_FACTOR("KHR_materials_diffuse_transmission", "diffuseTransmissionColorFactor", vec3,
                   diffuse_transmission_color, 1.0f, 0.0f, 1.0f, kClamp, true, "colour of that light")

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

HM_EXTENDED_TEXTURE("KHR_materials_specular", "specularTexture", specular_texture, specular,
                    kEncodingLinear, "A strength")
HM_EXTENDED_TEXTURE("KHR_materials_specular", "specularColorTexture", specular_color_texture,
                    specular_color, kEncodingSrgb, "RGB colour")
HM_EXTENDED_TEXTURE("KHR_materials_clearcoat", "clearcoatTexture", clearcoat_texture, clearcoat,
                    kEncodingLinear, "R strength")
HM_EXTENDED_TEXTURE("KHR_materials_clearcoat", "clearcoatRoughnessTexture", clearcoat_roughness_texture,
                    clearcoat_roughness, kEncodingLinear, "G roughness")
HM_EXTENDED_TEXTURE("KHR_materials_clearcoat", "clearcoatNormalTexture", clearcoat_normal_texture,
                    clearcoat_normal, kEncodingLinear, "RGB tangent-space normal of the coat")
HM_EXTENDED_TEXTURE("KHR_materials_sheen", "sheenColorTexture", sheen_color_texture, sheen_color,
                    kEncodingSrgb, "RGB colour")
HM_EXTENDED_TEXTURE("KHR_materials_sheen", "sheenRoughnessTexture", sheen_roughness_texture,
                    sheen_roughness, kEncodingLinear, "A roughness")
HM_EXTENDED_TEXTURE("KHR_materials_anisotropy", "anisotropyTexture", anisotropy_texture, anisotropy,
                    kEncodingLinear, "RG direction, B strength")
HM_EXTENDED_TEXTURE("KHR_materials_iridescence", "iridescenceTexture", iridescence_texture, iridescence,
                    kEncodingLinear, "R strength")
HM_EXTENDED_TEXTURE("KHR_materials_iridescence", "iridescenceThicknessTexture",
                    iridescence_thickness_texture, iridescence_thickness, kEncodingLinear,
                    "G thickness between its limits")
HM_EXTENDED_TEXTURE("KHR_materials_transmission", "transmissionTexture", transmission_texture,
                    transmission, kEncodingLinear, "R share")
HM_EXTENDED_TEXTURE("KHR_materials_diffuse_transmission", "diffuseTransmissionTexture",
                    diffuse_transmission_texture, diffuse_transmission, kEncodingLinear, "A share")
HM_EXTENDED_TEXTURE("KHR_materials_diffuse_transmission", "diffuseTransmissionColorTexture",
                    diffuse_transmission_color_texture, diffuse_transmission_color, kEncodingSrgb,
                    "RGB colour")

#undef HM_FACTOR
#undef HM_TEXTURE
#undef HM_EXTENDED_FACTOR
#undef HM_EXTENDED_TEXTURE
