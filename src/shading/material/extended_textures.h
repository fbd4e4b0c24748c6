// All textures of an extended material, read at once.

// Texels by the names that parameters.inl gives them, 1 where there is no texture.
struct ExtendedTexels {
#define HM_EXTENDED_TEXTURE(owner, key, slot, texel, encoding, meaning) vec4 texel;
#include "shading/material/parameters.inl"
};

HM_CONST uint kExtendedTextures =
#define HM_EXTENDED_TEXTURE(owner, key, slot, texel, encoding, meaning) 1u +
#include "shading/material/parameters.inl"
    0u;

// One loop over the textures that there are: compilers of shaders then inline one lookup instead of
// a dozen, which takes them half a minute.
HM_FN void read_extended_texels(HM_IN(ExtendedMaterialData) m, vec2 uv0, vec2 uv1,
                                HM_OUT(ExtendedTexels) texels) {
    uint uses[kExtendedTextures];
    uint encodings[kExtendedTextures];
    vec4 found[kExtendedTextures];
    uint present = 0u;
    uint n = 0u;
#define HM_EXTENDED_TEXTURE(owner, key, slot, texel, encoding, meaning) \
    uses[n] = m.slot;                                                   \
    encodings[n] = encoding;                                            \
    found[n] = vec4(1.0f);                                              \
    present = present | (m.slot == 0u ? 0u : 1u << n);                  \
    n = n + 1u;
#include "shading/material/parameters.inl"
    for (uint rest = present; rest != 0u; rest = rest & (rest - 1u)) {
        uint i = lowest_bit(rest);
        found[i] = sample_texture(uses[i], encodings[i], uv0, uv1);
    }
    n = 0u;
#define HM_EXTENDED_TEXTURE(owner, key, slot, texel, encoding, meaning) \
    texels.texel = found[n];                                            \
    n = n + 1u;
#include "shading/material/parameters.inl"
}
