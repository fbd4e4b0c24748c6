// How a material's textures are read: read_normal(m, uv0, uv1) and so on, one function for each
// HM_TEXTURE of parameters.inl.
#define HM_TEXTURE(owner, key, slot, read, encoding, meaning)    \
    HM_FN vec4 read(HM_IN(MaterialData) m, vec2 uv0, vec2 uv1) { \
        return sample_texture(m.slot, encoding, uv0, uv1);       \
    }
#define HM_EXTENDED_TEXTURE(owner, key, slot, texel, encoding, meaning)
#include "shading/material/parameters.inl"
