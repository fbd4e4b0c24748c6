// The closest-hit stage: evaluates the surface and writes the payload. Ray generation combines it.

#ifdef HM_AOVS
#include "shading/path/aov_facts.h"
#else
#include "shading/path/aov_facts_off.h"
#endif

// Light sampling: direction, distance and the contribution if nothing occludes it.
HM_FN void shade_light_sample(HM_INOUT(PathPayload) p, HM_IN(Bsdf) b, HM_IN(Frame) frame, vec3 ng,
                              vec3 wo, HM_IN(uvec4) numbers) {
    HM_MAY_CONTRACT
    LightSample light;
    sample_light(numbers.x, numbers.y, unit_float(numbers.z), unit_float(numbers.w), p.next_origin,
                 light);
    if (!(light.pdf > 0.0f) || dot(light.wi, ng) <= 0.0f) return;
    float pdf_bsdf;
    vec3 f = eval_bsdf(b, wo, to_local(frame, light.wi), pdf_bsdf);
    float weight = 1.0f;
    if (!light.punctual && params.strategy == kStrategyMis)
        weight = mis_weight(light.pdf, pdf_bsdf);
    p.light_direction = light.wi;
    p.light_distance = light.distance;
    p.light_contribution = f * light.radiance * (weight / light.pdf);
    note_light_sample(p, b, wo, to_local(frame, light.wi), light.source);
}

// BSDF sampling: the next direction and the throughput weight.
HM_FN void shade_scatter(HM_INOUT(PathPayload) p, HM_IN(Bsdf) b, HM_IN(Frame) frame, vec3 ng,
                         vec3 wo, HM_IN(uvec4) numbers) {
    vec3 wi =
        sample_bsdf(b, wo, unit_float(numbers.x), unit_float(numbers.y), unit_float(numbers.z));
    float pdf;
    vec3 f = eval_bsdf(b, wo, wi, pdf);
    p.next_direction = to_world(frame, wi);
    p.pdf = pdf;
    p.weight = vec3(0.0f);
    if (pdf > 0.0f && dot(p.next_direction, ng) > 0.0f) p.weight = f * (1.0f / pdf);
    note_scatter(p, b, wo, wi);
}

#ifdef HM_EXTENDED
#include "shading/path/extended_hit.h"
#endif

HM_FN void closest_hit(HM_INOUT(PathPayload) p, HM_IN(HitIds) ids, vec3 origin, vec3 direction) {
    Surface s;
    load_surface(ids, origin, direction, s);
    HM_ROW(MaterialData) m = materials[s.material];
    p.hit_distance = s.hit_distance;
    p.passed_through = 0u;
    p.emitted = vec3(0.0f);
    p.emitted_pdf = 0.0f;
    p.weight = vec3(0.0f);
    p.light_contribution = vec3(0.0f);
    bool two_sided = (m.flags & kMaterialDoubleSided) != 0u;
    bool boundary = (m.flags & (kMaterialDoubleSided | kMaterialVolume)) != 0u;
    bool passes = p.bounce == 0u && !s.front && !boundary;
    p.next_origin = s.position + s.ng * (passes ? -s.error : s.error);
    if (passes) {
        p.passed_through = 1u;
        return;
    }
    if (s.front || two_sided) {
        float cos_light = -dot(s.ng, direction);
        p.emitted = surface_radiance(m, s.uv0, s.uv1, s.color, cos_light);
        if (p.bounce > 0u && max_component(p.emitted) > 0.0f)
            p.emitted_pdf = pdf_light_triangle(ids, s.geometry, s.hit_distance, cos_light);
    }
#ifdef HM_EXTENDED
    vec3 passed = transmittance(medium_before(p.media, m, s.front), s.hit_distance);
    p.emitted = p.emitted * passed;
#endif
    note_surface(p, ids, s);
    bool last = params.max_bounces != 0u && p.bounce >= params.max_bounces;
    if (last || (m.flags & kMaterialUnlit) != 0u) return;
#ifdef HM_EXTENDED
    if (is_extended(m)) {
        extended_hit(p, ids, s, m, direction);
        attenuate(p, passed);
        return;
    }
#endif

    MaterialPoint point;
    load_material(m, s, point);
    Frame frame;
    make_frame(s.ns, frame);
    vec3 wo = to_local(frame, -direction);
    Bsdf b;
    make_bsdf(point, wo, b);
    note_material(p, b, point.metallic);

    SamplerState numbers;
    resume_sample(p, numbers);
    uint dimension = kDimensionBounce + 8u * p.bounce;
    uvec4 scatter_numbers = sample_4d(numbers, dimension);
    p.roulette = scatter_numbers.w;
    uvec4 light_numbers = sample_4d(numbers, dimension + 4u);
    shade_light_sample(p, b, frame, s.ng, wo, light_numbers);
    shade_scatter(p, b, frame, s.ng, wo, scatter_numbers);
#ifdef HM_EXTENDED
    attenuate(p, passed);
#endif
}
