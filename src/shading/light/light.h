// Light sampling: one sample of all the scene's lights for a shading point, and, for MIS, the pdf
// with which it would have sampled what a ray hit.
//
// Tables: lights, light_alias.

struct LightSample {
    vec3 wi;         // unit, towards the light
    float distance;  // of the shadow ray
    vec3 radiance;   // times alpha coverage for emitters; irradiance for punctual lights
    float pdf;       // solid angle; for punctual lights the discrete probability; 0: no sample
    bool punctual;   // BSDF sampling cannot find it
    uint source;     // see kSourceEnvironment
};

// clang-format off
#include "shading/light/environment.h"
#include "shading/light/emitter.h"
// clang-format on

// A 32-bit number within the range of one kind of light, stretched to all 32 bits again.
HM_FN uint stretch_choice(HM_IN(LightRange) range, uint choice) {
    uint x = choice - range.begin;
    return x * range.scale_int + mul_high(x, range.scale_frac);
}

HM_FN bool in_range(HM_IN(LightRange) range, uint choice) {
    return choice >= range.begin && choice < range.end;
}

HM_FN void begin_light_sample(HM_OUT(LightSample) light) {
    light.wi = vec3(0.0f, 0.0f, 1.0f);
    light.distance = 0.0f;
    light.radiance = vec3(0.0f);
    light.pdf = 0.0f;
    light.punctual = false;
    light.source = kSourceEnvironment;
}

// One of the punctual lights; its pdf is the probability of the choice.
HM_FN void sample_punctual_lights(uint choice, uint coin, vec3 p, HM_INOUT(LightSample) light) {
    uint slot = alias_slot(choice, params.light_count);
    AliasDraw drawn;
    draw_alias(slot, light_alias[slot], coin, drawn);
    PunctualSample s;
    sample_punctual(lights[drawn.index], p, s);
    light.wi = s.wi;
    light.distance = s.distance;
    light.radiance = s.irradiance;
    light.pdf = drawn.pdf;
    light.punctual = true;
    light.source = 1u + drawn.index;
}

// `choice` picks the kind of light and, stretched, a slot of its alias table; `coin` decides within
// the slot; u and v in [0, 1) pick a point.
HM_FN void sample_light(uint choice, uint coin, float u, float v, vec3 p,
                        HM_OUT(LightSample) light) {
    begin_light_sample(light);
    if (in_range(params.environment_range, choice)) {
        uint inner = stretch_choice(params.environment_range, choice);
        vec3 radiance;
        float pdf;
        light.wi = sample_environment(inner, coin, u, v, radiance, pdf);
        light.radiance = radiance;
        light.pdf = pdf * params.environment_range.pdf;
        light.distance = kInfinity;
    } else if (in_range(params.punctual_range, choice)) {
        uint inner = stretch_choice(params.punctual_range, choice);
        sample_punctual_lights(inner, coin, p, light);
        light.pdf = params.punctual_range.pdf * light.pdf;
    } else if (in_range(params.emitter_range, choice)) {
        uint inner = stretch_choice(params.emitter_range, choice);
        sample_emitter(inner, coin, u, v, p, light);
        light.pdf = light.pdf * params.emitter_range.pdf;
    }
}

// Solid-angle pdf with which sample_light samples a direction of the environment; 0 if it never
// does.
HM_FN float pdf_light_environment(vec3 direction, vec2 uv) {
    if (!(params.environment_range.pdf > 0.0f)) return 0.0f;
    return params.environment_range.pdf * pdf_environment(direction, uv);
}

// The same for the point where a ray hit a triangle, at this distance and cosine.
HM_FN float pdf_light_triangle(HM_IN(HitIds) ids, uint geometry, float hit_distance,
                               float cos_light) {
    uint index = emitter_index(ids, geometry);
    if (index == kNone || params.emitter_range.pdf <= 0.0f) return 0.0f;
    return pdf_emitter(params.emitter_range.pdf, index, hit_distance, cos_light);
}
