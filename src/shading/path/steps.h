// The steps of a path. Ray generation calls them in turn (ray_generation.h). Their only state is
// the path's state, payload and sample, so other loops (queues, SIMD) can call them as well.
//
// Hooks: trace_path finds the closest hit and runs closest_hit or miss; trace_visible traces a
// shadow ray and returns whether nothing occludes it before t_max; both offer hits on mask and
// blend materials to any_hit_accepts. Tables: filter_table[kFilterSize] is the inverse of the pixel
// filter's distribution over [-1, 1].

HM_HOOK(void trace_path(HM_INOUT(PathPayload) payload, vec3 origin, vec3 direction))
HM_HOOK(bool trace_visible(vec3 origin, vec3 direction, float t_max, uint key, uint index))

#ifdef HM_AOVS
#include "shading/path/aovs.h"
#else
#include "shading/path/aovs_off.h"
#endif

HM_CONST uint kFilterSize = 257u;
HM_CONST uint kRouletteFrom = 2u;

HM_CONST uint kRayRadiance = 0u;
HM_CONST uint kRayShadow = 1u;

// Of a path's stochastic alpha. The sample's index orders a sequence of each key (any_hit.h);
// independent numbers have it in their key.
HM_FN uint begin_alpha_key(HM_IN(SamplerState) numbers, uint index) {
    if (params.sampler_kind == kSamplerIndependent) return hash_combine(numbers.key, index);
    return numbers.key;
}

// Of one ray of a path; any_hit_accepts hashes it together with the ids of the triangle.
HM_FN uint ray_key(uint alpha_key, uint bounce, uint ray_kind) {
    return alpha_key + (2u * bounce + ray_kind) * 0x9e3779b9u;
}

HM_FN float sample_filter(float u) {
    float x = u * float(kFilterSize - 1u);
    uint i = min(uint(x), kFilterSize - 2u);
    float f = x - float(i);
    return (filter_table[i] * (1.0f - f) + filter_table[i + 1u] * f) * 0.5f * params.filter_width;
}

HM_FN void camera_ray(HM_IN(SamplerState) numbers, HM_OUT(CameraRay) ray) {
    uvec4 x = sample_4d(numbers, kDimensionPixel);
    float px = float(numbers.pixel_x) + 0.5f + sample_filter(unit_float(x.x));
    float py = float(numbers.pixel_y) + 0.5f + sample_filter(unit_float(x.y));
    vec2 film = vec2(divide(px, float(params.width)), divide(py, float(params.height)));
    make_camera_ray(camera, film, unit_float(x.z), unit_float(x.w), ray);
}

// Adds one contribution and returns what it added; indirect ones are scaled down to the clamp as a
// whole.
HM_FN vec3 add_contribution(HM_INOUT(PathSample) s, vec3 contribution, bool indirect) {
    HM_MAY_CONTRACT
    vec3 kept = contribution;
    float largest = max_component(contribution);
    if (indirect && params.max_radiance > 0.0f && largest > params.max_radiance) {
        kept = contribution * (params.max_radiance / largest);
        s.removed = s.removed + luminance(contribution - kept);
    }
    s.radiance = s.radiance + kept;
    return kept;
}

// The MIS weight of radiance that a BSDF-sampled ray found.
HM_FN float emission_weight(uint bounce, float pdf_bsdf, float pdf_light) {
    if (bounce == 0u || !(pdf_light > 0.0f)) return 1.0f;
    if (params.strategy == kStrategyLight) return 0.0f;
    return mis_weight(pdf_bsdf, pdf_light);
}

// Russian roulette: from bounce 2 on a path survives with the probability of its throughput's
// largest component.
HM_FN bool survive_roulette(uint number, uint bounce, HM_INOUT(vec3) throughput) {
    if (bounce < kRouletteFrom) return true;
    float survival = clamp(max_component(throughput), 0.05f, 0.95f);
    if (unit_float(number) >= survival) return false;
    throughput = throughput * (1.0f / survival);
    return true;
}

// Begin: a camera ray through the pixel, its filter and the lens, with full throughput.
HM_FN void begin_path(uint pixel_x, uint pixel_y, uint index, HM_OUT(PathState) path,
                      HM_OUT(PathPayload) p, HM_OUT(PathSample) s) {
    s.radiance = vec3(0.0f);
    s.alpha = 1.0f;
    s.removed = 0.0f;
    s.rays = 0u;
    begin_aovs(s);
    SamplerState numbers;
    begin_sample(pixel_x, pixel_y, index, numbers);
    CameraRay ray;
    camera_ray(numbers, ray);
    path.origin = ray.origin;
    path.direction = ray.direction;
    path.throughput = vec3(1.0f);
    path.pdf_bsdf = 0.0f;
    path.alpha_key = begin_alpha_key(numbers, index);
    p.index = numbers.index;
    p.pixel = pixel_x | (pixel_y << 16u);
    p.bounce = 0u;
    p.media = 0u;
    // Compilers do not see that these are written before they are read.
    p.next_origin = ray.origin;
    p.next_direction = ray.direction;
#ifdef HM_AOVS
    p.replicate = numbers.replicate;
#endif
}

// Extend: traces the path's ray; closest_hit or miss fills the payload. False if a camera ray
// passed through a single-sided back face: it continues behind it.
HM_FN bool extend_path(HM_INOUT(PathState) path, HM_INOUT(PathPayload) p, HM_INOUT(PathSample) s) {
    p.key = ray_key(path.alpha_key, p.bounce, kRayRadiance);
    trace_path(p, path.origin, path.direction);
    s.rays = s.rays + 1u;
    if (p.passed_through == 0u) return true;
    path.origin = p.next_origin;
    return false;
}

// Shade: adds the emission of what the ray hit, weighted against light sampling (MIS). False if the
// ray left the scene.
HM_FN bool shade_path(HM_IN(PathState) path, HM_IN(PathPayload) p, HM_INOUT(PathSample) s) {
    HM_MAY_CONTRACT
    float weight = emission_weight(p.bounce, path.pdf_bsdf, p.emitted_pdf);
    vec3 emitted = add_contribution(s, path.throughput * p.emitted * weight, p.bounce > 1u);
    note_emitted(s, p, emitted);
    if (p.hit_distance >= 0.0f) return true;
    if (p.bounce == 0u && params.background == kBackgroundTransparent) s.alpha = 0.0f;
    return false;
}

// Connect: traces a shadow ray to the hit's light sample, and adds its light if it is visible.
HM_FN void connect_path(HM_IN(PathState) path, HM_IN(PathPayload) p, HM_INOUT(PathSample) s) {
    HM_MAY_CONTRACT
    if (!(max_component(p.light_contribution) > 0.0f)) return;
    s.rays = s.rays + 1u;
    uint key = ray_key(path.alpha_key, p.bounce, kRayShadow);
    if (!trace_visible(p.next_origin, p.light_direction, p.light_distance, key, p.index)) return;
    vec3 lit = add_contribution(s, path.throughput * p.light_contribution, p.bounce > 0u);
    note_lit(s, p, lit);
}

// Scatter: continues in the direction that the BSDF sampled. False if the throughput is zero or
// Russian roulette ends the path.
HM_FN bool scatter_path(HM_INOUT(PathState) path, HM_INOUT(PathPayload) p, HM_INOUT(PathSample) s) {
    HM_MAY_CONTRACT
    note_first_scatter(s, p);
    path.throughput = path.throughput * p.weight;
    if (max_component(path.throughput) <= 0.0f) return false;
    p.bounce = p.bounce + 1u;
    if (!survive_roulette(p.roulette, p.bounce, path.throughput)) return false;
    path.pdf_bsdf = p.pdf;
    path.origin = p.next_origin;
    path.direction = p.next_direction;
    return true;
}
