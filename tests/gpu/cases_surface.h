// Parity of GGX, camera rays, punctual lights, ray origins, bent normals and colour.
#include "gpu/case.h"
#include "shading/camera.h"
#include "shading/color.h"
#include "shading/frame.h"
#include "shading/geometry.h"
#include "shading/light/punctual.h"
#include "shading/material/ggx.h"

HM_CASES_BEGIN(25, 1)

HM_FN void run_ggx(uint index, HM_INOUT(CaseResult) result) {
    float u = case_unit(index, 10u);
    float v = case_unit(index, 11u);
    float roughness = case_between(index, 12u, 0.04f, 1.0f);
    float alpha = roughness * roughness;
    vec3 wo = case_upper_direction(index, 13u);
    vec3 h = case_upper_direction(index, 14u);
    // The logarithm of the density, which spans many orders of magnitude.
    result.values[0] = log2(eval_ggx_d(h, alpha));
    result.values[1] = eval_ggx_v(wo.z, h.z, alpha);
    result.values[2] = log2(eval_ggx_d(h, alpha) * ggx_reflection_pdf_scale(wo, alpha));
    vec3 wi = sample_ggx_reflection(wo, alpha, u, v);
    result.values[3] = wi.x;
    result.values[4] = wi.y;
    result.values[5] = wi.z;
}

HM_FN void run_camera(uint index, HM_INOUT(CaseResult) result) {
    Frame frame;
    make_frame(case_direction(index, 20u), frame);
    CameraData camera;
    camera.origin = 10.0f * case_direction(index, 21u);
    camera.right = frame.s;
    camera.up = frame.t;
    camera.forward = frame.n;
    camera.half_width = case_between(index, 22u, 0.1f, 2.0f);
    camera.half_height = case_between(index, 23u, 0.1f, 2.0f);
    camera.lens_radius = (index & 2u) != 0u ? 0.05f : 0.0f;
    camera.focus_distance = case_between(index, 24u, 0.5f, 20.0f);
    camera.kind = index & 1u;
    vec2 film = vec2(case_unit(index, 25u), case_unit(index, 26u));
    float lens_u = case_unit(index, 27u);
    float lens_v = case_unit(index, 28u);
    CameraRay ray;
    make_camera_ray(camera, film, lens_u, lens_v, ray);
    result.values[6] = ray.origin.x;
    result.values[7] = ray.origin.y;
    result.values[8] = ray.origin.z;
    result.values[9] = ray.direction.x;
    result.values[10] = ray.direction.y;
    result.values[11] = ray.direction.z;
}

HM_FN void run_light(uint index, HM_INOUT(CaseResult) result) {
    LightData light;
    light.position = 3.0f * case_direction(index, 30u);
    light.direction = case_direction(index, 31u);
    light.color = vec3(1.0f, 10.0f, 100.0f);
    light.range = (index & 4u) != 0u ? 6.0f : 0.0f;
    light.spot_scale = case_between(index, 32u, 1.0f, 10.0f);
    light.spot_offset = case_between(index, 33u, -0.5f, 0.5f);
    light.kind = case_bits(index, 34u) % 3u;
    light.surface_normal = case_direction(index, 36u);
    light.surface_error = (index & 8u) != 0u ? 0.01f : 0.0f;
    PunctualSample light_sample;
    sample_punctual(light, case_direction(index, 35u), light_sample);
    result.values[12] = light_sample.wi.x;
    result.values[13] = light_sample.wi.y;
    result.values[14] = light_sample.wi.z;
    result.values[15] = light_sample.distance;
    result.values[16] = light_sample.irradiance.z;
}

HM_FN void run_geometry(uint index, HM_INOUT(CaseResult) result) {
    vec3 p = case_between(index, 40u, 0.0f, 10.0f) * case_direction(index, 41u);
    vec3 ng = case_upper_direction(index, 42u);
    vec3 offset = p + ng * hit_error(abs(p), case_between(index, 44u, 0.0f, 10.0f), ng);
    result.values[17] = offset.x;
    result.values[18] = offset.y;
    result.values[19] = offset.z;
    vec3 wo = case_upper_direction(index, 43u);
    vec3 bent = bend_shading_normal(ng, vec3(0.0f, 0.0f, 1.0f), wo);
    result.values[20] = bent.x;
    result.values[21] = bent.z;
    result.choices[0] = offset.x != p.x ? 1u : 0u;
}

HM_FN void run_color(uint index, HM_INOUT(CaseResult) result) {
    float x = case_between(index, 50u, 0.0f, 1.0f);
    vec3 radiance = vec3(case_between(index, 51u, 0.0f, 4.0f), case_between(index, 52u, 0.0f, 4.0f),
                         case_between(index, 53u, 0.0f, 4.0f));
    vec3 mapped = tone_map(radiance, index & 3u);
    result.values[22] = srgb_to_linear(x);
    result.values[23] = linear_to_srgb(x);
    result.values[24] = mapped.y;
}

HM_FN void run_case(uint index, HM_OUT(CaseResult) result) {
    run_ggx(index, result);
    run_camera(index, result);
    run_light(index, result);
    run_geometry(index, result);
    run_color(index, result);
}

HM_CASES_END
