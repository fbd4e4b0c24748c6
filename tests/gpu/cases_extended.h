// Parity of the lobes of extended materials: boundaries, films, fibres, and the whole BSDF over its
// tables.
#include "gpu/case.h"
#include "shading/shading.h"
#ifdef __cplusplus
#include "gpu/path_tracer.h"
#else
#define HM_EXTENDED
#include "gpu/path_tables.glsl"
#endif

HM_STAGE_CASES_BEGIN(22, 4)

HM_FN void run_boundary(uint index, HM_INOUT(CaseResult) result) {
    float cosine = case_unit(index, 10u);
    float eta = case_between(index, 11u, 0.4f, 2.5f);
    float cos_t;
    result.values[0] = fresnel_dielectric(cosine, eta, cos_t);
    result.values[1] = cos_t;
    vec3 f0 = vec3(case_unit(index, 12u), case_unit(index, 13u), case_unit(index, 14u));
    vec3 film = thin_film_fresnel(case_between(index, 15u, 1.1f, 2.2f),
                                  case_between(index, 16u, 0.0f, 800.0f), f0, cosine);
    result.values[2] = film.x;
    result.values[3] = film.y;
    result.values[4] = film.z;
    vec3 wo = case_upper_direction(index, 17u);
    vec3 wi = case_upper_direction(index, 18u);
    result.values[5] = log2(1e-6f + eval_sheen(wo, wi, case_unit(index, 19u)));
    vec3 h = case_upper_direction(index, 20u);
    if (dot(wo, h) < 0.0f) h = -h;
    vec3 refracted = refract_about(wo, h, eta);
    result.values[6] = refracted.x;
    result.values[7] = refracted.z;
    result.choices[0] = dot(refracted, refracted) > 0.5f ? 1u : 0u;
}

HM_FN void random_point(uint index, HM_OUT(ExtendedPoint) p) {
    p.specular_color =
        vec3(case_unit(index, 30u), case_unit(index, 31u), case_unit(index, 32u)) * 2.0f;
    p.specular = case_unit(index, 33u);
    p.ior = case_between(index, 34u, 1.0f, 2.5f);
    p.glossy = (index & 31u) == 0u;
    p.clearcoat = (index & 1u) != 0u ? case_unit(index, 35u) : 0.0f;
    p.clearcoat_roughness = case_unit(index, 36u);
    p.sheen_color = (index & 2u) != 0u ? vec3(case_unit(index, 37u)) : vec3(0.0f);
    p.sheen_roughness = case_unit(index, 38u);
    p.anisotropy = (index & 4u) != 0u ? case_unit(index, 39u) : 0.0f;
    p.anisotropy_direction = vec2(1.0f, 0.0f);
    p.iridescence = (index & 8u) != 0u ? case_unit(index, 40u) : 0.0f;
    p.iridescence_ior = 1.4f;
    p.iridescence_thickness = case_between(index, 41u, 50.0f, 700.0f);
    p.transmission = (index & 16u) != 0u ? case_unit(index, 42u) : 0.0f;
    p.diffuse_transmission = case_unit(index, 43u);
    p.diffuse_transmission_color = vec3(case_unit(index, 44u));
}

HM_FN void run_bsdf(uint index, HM_INOUT(CaseResult) result) {
    MaterialPoint base;
    base.base_color = vec3(case_unit(index, 50u), case_unit(index, 51u), case_unit(index, 52u));
    base.metallic = case_unit(index, 53u);
    base.roughness = case_between(index, 54u, 0.0f, 1.0f);
    base.specular_weight = 1.0f;
    ExtendedPoint point;
    random_point(index, point);
    vec3 wo = case_upper_direction(index, 55u);
    vec3 wi = case_direction(index, 56u);
    bool thin = (index & 64u) != 0u;
    float eta = (index & 128u) != 0u ? point.ior : 1.0f / point.ior;
    ExtendedBsdf b;
    make_extended_bsdf(base, point, wo, vec3(0.0f, 0.0f, 1.0f), eta, thin, b);
    result.values[8] = b.transmits;
    result.values[9] = b.specular_probability;
    result.values[10] = b.diffuse.x;
    result.values[11] = b.diffuse_transmitted.y;
    result.values[12] = b.specular.f0.z;
    bool far = wi.z < 0.0f;
    vec3 diffuse;
    float pdf;
    vec3 f = eval_extended(b, far, wo, wi, diffuse, pdf);
    result.values[13] = log2(1e-6f + f.x);
    result.values[14] = log2(1e-6f + f.z);
    result.values[15] = log2(1e-6f + pdf);
    result.values[16] = diffuse.y;
    float lobe = case_unit(index, 57u);
    ExtendedSample drawn;
    sample_extended(b, far, wo, lobe, case_unit(index, 58u), case_unit(index, 59u), drawn);
    result.values[17] = drawn.wi.x;
    result.values[18] = drawn.wi.y;
    result.values[19] = drawn.wi.z;
    result.choices[1] = b.transmits > 0.5f ? 1u : 0u;
    result.choices[2] = drawn.pdf > 0.0f ? 1u : 0u;
}

HM_FN void run_media(uint index, HM_INOUT(CaseResult) result) {
    uint media = 0u;
    for (uint i = 0u; i < 6u; ++i) {
        uint medium = 1u + case_bits(index, 70u + i) % 5u;
        if (medium_shift(media, medium) != 30u)
            media = leave_medium(media, medium);
        else
            media = enter_medium(media, medium);
    }
    media = with_channel(media, case_bits(index, 76u) & 3u);
    result.choices[3] = media;
    result.values[20] = float(top_medium(media));
    result.values[21] = float(path_channel(media));
}

HM_FN void run_case(uint index, HM_OUT(CaseResult) result) {
    run_boundary(index, result);
    run_bsdf(index, result);
    run_media(index, result);
}

HM_STAGE_CASES_END
