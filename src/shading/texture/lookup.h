// Texture lookups over fetched texels: wrap modes, nearest and bilinear filtering with float
// weights. Minification is left to the many samples of a pixel.
//
// Hooks: fetch_texel returns a decoded, linear texel; image_size its picture's width and height.

HM_HOOK(uvec2 image_size(uint image))
HM_HOOK(vec4 fetch_texel(uint image, uint x, uint y, uint encoding))

// Image 0 is a 1x1 white image, used for missing textures.
HM_CONST uint kImageWhite = 0u;

// A coordinate wrapped into [0, 1]; non-finite values become 0.
HM_FN float fold_coordinate(float u, uint wrap) {
    float x = u;
    if (wrap == kWrapRepeat) {
        x = u - floor(u);
    } else if (wrap == kWrapMirror) {
        x = u - 2.0f * floor(0.5f * u);
        x = x > 1.0f ? 2.0f - x : x;
    } else {
        x = clamp(u, 0.0f, 1.0f);
    }
    return x >= 0.0f && x <= 1.0f ? x : 0.0f;
}

// Texel indices -1..n brought back into 0..n-1. Mirroring is clamping at the edge.
HM_FN uint wrap_texel(int i, int n, uint wrap) {
    if (i < 0) return wrap == kWrapRepeat ? uint(n - 1) : 0u;
    if (i >= n) return wrap == kWrapRepeat ? 0u : uint(n - 1);
    return uint(i);
}

HM_FN vec4 sample_texture(uint texture_use, uint encoding, vec2 uv0, vec2 uv1) {
    HM_ROW(TextureUse) t = texture_uses[texture_use];
    if (t.image == kImageWhite) return vec4(1.0f);
    vec2 uv = t.uv_set == 0u ? uv0 : uv1;
    float u = t.uv_row_u.x * uv.x + t.uv_row_u.y * uv.y + t.uv_row_u.z;
    float v = t.uv_row_v.x * uv.x + t.uv_row_v.y * uv.y + t.uv_row_v.z;
    uvec2 size = image_size(t.image);
    float x = fold_coordinate(u, t.wrap_u) * float(size.x);
    float y = fold_coordinate(v, t.wrap_v) * float(size.y);
    if (t.filter_mode == kFilterNearest) {
        uint i = wrap_texel(int(x), int(size.x), kWrapClamp);
        uint j = wrap_texel(int(y), int(size.y), kWrapClamp);
        return fetch_texel(t.image, i, j, encoding);
    }
    float left = floor(x - 0.5f);
    float top = floor(y - 0.5f);
    float fx = x - 0.5f - left;
    float fy = y - 0.5f - top;
    uint i0 = wrap_texel(int(left), int(size.x), t.wrap_u);
    uint i1 = wrap_texel(int(left) + 1, int(size.x), t.wrap_u);
    uint j0 = wrap_texel(int(top), int(size.y), t.wrap_v);
    uint j1 = wrap_texel(int(top) + 1, int(size.y), t.wrap_v);
    vec4 upper = fetch_texel(t.image, i0, j0, encoding) * (1.0f - fx) +
                 fetch_texel(t.image, i1, j0, encoding) * fx;
    vec4 lower = fetch_texel(t.image, i0, j1, encoding) * (1.0f - fx) +
                 fetch_texel(t.image, i1, j1, encoding) * fx;
    return upper * (1.0f - fy) + lower * fy;
}
