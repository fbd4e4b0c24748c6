// Directional albedo of the GGX lobe, split by Schlick's Fresnel into f0 * x + f90 * y. x + y is
// the albedo of a perfect mirror; what it lacks to 1 is light that meets the microfacets more than
// once.
//
// Tables: albedo_table[kAlbedoRows * kAlbedoColumns], albedo_average[kAlbedoRows]: x and y. Entries
// are fitted to what lookups interpolate (tools/make_albedo_table), so that white metal gains or
// loses less than 1e-4 of the light at any roughness.

// The split albedo at a cosine.
HM_FN vec2 lookup_albedo(float cos_theta, float roughness) {
    HM_MAY_CONTRACT
    float column = fast_sqrt(saturate(cos_theta)) * float(kAlbedoColumns - 1u);
    float row = saturate(roughness) * float(kAlbedoRows - 1u);
    uint c = min(uint(column), kAlbedoColumns - 2u);
    uint r = min(uint(row), kAlbedoRows - 2u);
    float fc = column - float(c);
    float fr = row - float(r);
    uint i = r * kAlbedoColumns + c;
    uint j = i + kAlbedoColumns;
    vec2 low = albedo_table[i] * (1.0f - fc) + albedo_table[i + 1u] * fc;
    vec2 high = albedo_table[j] * (1.0f - fc) + albedo_table[j + 1u] * fc;
    return low * (1.0f - fr) + high * fr;
}

// Its cosine-weighted mean over all directions.
HM_FN vec2 lookup_albedo_average(float roughness) {
    float row = saturate(roughness) * float(kAlbedoRows - 1u);
    uint r = min(uint(row), kAlbedoRows - 2u);
    float fr = row - float(r);
    return albedo_average[r] * (1.0f - fr) + albedo_average[r + 1u] * fr;
}

// Fresnel factor F_ms of light that scattered more than once between microfacets (Hill 2018), for
// an average mirror albedo. The cosine-weighted mean of Schlick is f0 + (f90 - f0) / 21.
HM_FN float multiple_fresnel(float f0, float f90, float e_average) {
    float f = f0 + (f90 - f0) / 21.0f;
    return f * f * e_average / (1.0f - f * (1.0f - e_average));
}
