// Tabulated directional albedos of the lobes of extended materials, from which their layers let
// through what is not reflected, and rough lobes get back what single scattering loses.
//
// Tables: sheen_albedo, glass_albedo, anisotropic_albedo (tools/make_energy_tables).

// Two neighbouring nodes of an even axis with `count` nodes: the first one's index and the share of
// the second.
HM_FN uint table_node(float at, uint count, HM_OUT(float) share) {
    float x = saturate(at) * float(count - 1u);
    uint i = min(uint(x), count - 2u);
    share = x - float(i);
    return i;
}

// Of white sheen; up to 1.1 at the roughest grazing angles, where the fit of its shadowing is
// short.
HM_FN float lookup_sheen_albedo(float cos_theta, float roughness) {
    HM_MAY_CONTRACT
    float fc;
    float fr;
    uint c = table_node(fast_sqrt(saturate(cos_theta)), kSheenColumns, fc);
    uint r =
        table_node((roughness - kMinSheenRoughness) / (1.0f - kMinSheenRoughness), kSheenRows, fr);
    uint i = r * kSheenColumns + c;
    uint j = i + kSheenColumns;
    float low = sheen_albedo[i] * (1.0f - fc) + sheen_albedo[i + 1u] * fc;
    float high = sheen_albedo[j] * (1.0f - fc) + sheen_albedo[j + 1u] * fc;
    return low * (1.0f - fr) + high * fr;
}

HM_FN vec2 lookup_glass_row(uint first, float row, float column) {
    HM_MAY_CONTRACT
    float fc;
    float fr;
    uint c = table_node(column, kGlassColumns, fc);
    uint r = table_node(row, kGlassRows, fr);
    uint i = first + r * kGlassColumns + c;
    uint j = i + kGlassColumns;
    vec2 low = glass_albedo[i] * (1.0f - fc) + glass_albedo[i + 1u] * fc;
    vec2 high = glass_albedo[j] * (1.0f - fc) + glass_albedo[j + 1u] * fc;
    return low * (1.0f - fr) + high * fr;
}

// What one scattering event on a rough boundary reflects (x) and lets through (y). `eta` is the
// index beyond over that on the side of the light; from 1/4 to 4.
HM_FN vec2 lookup_glass_albedo(float cos_theta, float roughness, float eta) {
    HM_MAY_CONTRACT
    float f;
    float larger = eta < 1.0f ? 1.0f / eta : eta;
    uint side = eta < 1.0f ? kGlassIndices : 0u;
    uint n = table_node((larger - 1.0f) / (larger + 1.0f) * (5.0f / 3.0f), kGlassIndices, f);
    uint rows = kGlassRows * kGlassColumns;
    float column = fast_sqrt(saturate(cos_theta));
    vec2 low = lookup_glass_row((side + n) * rows, roughness, column);
    vec2 high = lookup_glass_row((side + n + 1u) * rows, roughness, column);
    return low * (1.0f - f) + high * f;
}

HM_FN vec2 lookup_anisotropic_row(uint row, float azimuth, float column) {
    HM_MAY_CONTRACT
    float fa;
    float fc;
    uint a = table_node(azimuth, kAnisotropyAzimuths, fa);
    uint c = table_node(column, kAnisotropyColumns, fc);
    uint i = (row * kAnisotropyAzimuths + a) * kAnisotropyColumns + c;
    uint j = i + kAnisotropyColumns;
    vec2 low = anisotropic_albedo[i] * (1.0f - fc) + anisotropic_albedo[i + 1u] * fc;
    vec2 high = anisotropic_albedo[j] * (1.0f - fc) + anisotropic_albedo[j + 1u] * fc;
    return low * (1.0f - fa) + high * fa;
}

// The split albedo (material/albedo.h) of a highlight stretched along x.
HM_FN vec2 lookup_anisotropic_albedo(vec3 w, float roughness, float strength) {
    HM_MAY_CONTRACT
    float fs;
    float fr;
    uint s = table_node(strength, kAnisotropyStrengths, fs);
    uint r = table_node(roughness, kAnisotropyRows, fr);
    float across = w.x * w.x + w.y * w.y;
    float azimuth = across > 1e-12f ? w.y * w.y / across : 0.0f;
    float column = fast_sqrt(saturate(w.z));
    uint row = s * kAnisotropyRows + r;
    vec2 a = lookup_anisotropic_row(row, azimuth, column) * (1.0f - fr) +
             lookup_anisotropic_row(row + 1u, azimuth, column) * fr;
    row = row + kAnisotropyRows;
    vec2 b = lookup_anisotropic_row(row, azimuth, column) * (1.0f - fr) +
             lookup_anisotropic_row(row + 1u, azimuth, column) * fr;
    return a * (1.0f - fs) + b * fs;
}
