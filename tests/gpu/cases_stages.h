// Parity of what the stages compute from tables: sample numbers, texture lookups, the mixture of
// lobes and light samples, over the tables of TestScene.
#include "gpu/case.h"
#include "shading/shading.h"
#ifdef __cplusplus
#include "gpu/path_tracer.h"
#else
#include "gpu/path_tables.glsl"
#endif

HM_STAGE_CASES_BEGIN(18, 8)

HM_FN void run_sampler(uint index, HM_INOUT(CaseResult) result) {
    SamplerState s;
    begin_sample(index & 1023u, index >> 10u, case_bits(index, 0u) & 65535u, s);
    uint dimension = (case_bits(index, 1u) & 31u) * 4u;
    uvec4 owen = sample_sobol_owen(s, dimension);
    result.choices[0] = owen.x ^ owen.y ^ owen.z ^ owen.w;
    result.choices[1] = sample_sobol_blue_noise(s, dimension);
    uvec4 numbers = sample_4d(s, dimension);
    result.choices[2] = numbers.x ^ numbers.y ^ numbers.z ^ numbers.w;
    result.values[0] = sample_filter(case_unit(index, 2u));
    HitIds ids;
    ids.instance = case_bits(index, 3u) & 7u;
    ids.geometry = case_bits(index, 4u) & 7u;
    ids.primitive = case_bits(index, 5u) & 1023u;
    uint key = ray_key(begin_alpha_key(s, s.index), index & 7u, kRayShadow);
    result.choices[7] = float_bits(alpha_number(key, s.index, ids));
}

HM_FN void run_texture(uint index, HM_INOUT(CaseResult) result) {
    vec2 uv0 = vec2(case_between(index, 10u, -3.0f, 3.0f), case_between(index, 11u, -3.0f, 3.0f));
    vec2 uv1 = vec2(case_unit(index, 12u), case_unit(index, 13u));
    uint texture_use = 1u + case_bits(index, 14u) % 4u;
    uint encoding = case_bits(index, 16u) & 1u;
    vec4 texel = sample_texture(texture_use, encoding, uv0, uv1);
    result.values[1] = texel.x;
    result.values[2] = texel.y;
    result.values[3] = texel.w;
    vec2 uv = environment_uv(case_direction(index, 15u));
    vec3 radiance = environment_radiance(uv);
    result.values[4] = radiance.x;
    result.choices[3] = uint(uv.x * float(environment.width));
}

HM_FN void run_bsdf(uint index, HM_INOUT(CaseResult) result) {
    MaterialPoint point;
    point.base_color = vec3(case_unit(index, 20u), case_unit(index, 21u), case_unit(index, 22u));
    point.metallic = case_unit(index, 23u);
    point.roughness = case_between(index, 24u, 0.05f, 1.0f);
    point.specular_weight = 1.0f;
    vec3 wo = case_upper_direction(index, 25u);
    vec3 wi = case_upper_direction(index, 26u);
    Bsdf b;
    make_bsdf(point, wo, b);
    float pdf;
    vec3 f = eval_bsdf(b, wo, wi, pdf);
    result.values[5] = b.specular.probability;
    result.values[6] = f.x;
    result.values[7] = f.z;
    result.values[8] = pdf;
    float lobe = case_unit(index, 27u);
    vec3 sampled = sample_bsdf(b, wo, lobe, case_unit(index, 28u), case_unit(index, 29u));
    result.values[9] = sampled.x;
    result.values[10] = sampled.z;
    result.choices[4] = lobe < b.specular.probability ? 1u : 0u;
}

HM_FN void run_light(uint index, HM_INOUT(CaseResult) result) {
    vec3 p = 1.8f * case_direction(index, 30u);
    LightSample light;
    sample_light(case_bits(index, 31u), case_bits(index, 32u), case_unit(index, 33u),
                 case_unit(index, 34u), p, light);
    result.values[11] = light.wi.x;
    result.values[12] = light.wi.y;
    result.values[13] = light.wi.z;
    result.values[14] = log2(1.0f + light.radiance.x);
    result.values[15] = log2(1.0f + light.pdf);
    result.choices[5] = light.punctual ? 1u : 0u;
    result.choices[6] = light.pdf > 0.0f ? 1u : 0u;

    vec3 direction = case_direction(index, 35u);
    vec2 uv = environment_uv(direction);
    result.values[16] = log2(1.0f + pdf_environment(direction, uv));
    result.values[17] = emission_weight(index & 1u, case_unit(index, 36u), case_unit(index, 37u));
}

HM_FN void run_case(uint index, HM_OUT(CaseResult) result) {
    run_sampler(index, result);
    run_texture(index, result);
    run_bsdf(index, result);
    run_light(index, result);
}

HM_STAGE_CASES_END
