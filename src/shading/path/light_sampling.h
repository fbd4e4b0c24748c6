// One light sample for a shading point: environment, punctual light or emissive triangle.
//
// Tables: lights, light_alias.

// 32-bit numbers of one kind's range, stretched over all 32 bits again.
HM_FN uint stretch_choice(HM_IN(LightRange) range, uint choice) {
    uint x = choice - range.begin;
    return x * range.scale_int + mul_high(x, range.scale_frac);
}

HM_FN bool in_range(HM_IN(LightRange) range, uint choice) {
    return choice >= range.begin && choice < range.end;
}

HM_FN void sample_light(uint choice, uint coin, float u, float v, vec3 p,
                        HM_OUT(LightSample) light) {
    light.wi = vec3(0.0f, 0.0f, 1.0f);
    light.distance = 0.0f;
    light.radiance = vec3(0.0f);
    light.pdf = 0.0f;
    light.punctual = false;
    light.source = kSourceEnvironment;
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
        uint slot = mul_high(inner, params.light_count);
        HM_ROW(AliasEntry) entry = light_alias[slot];
        bool own = coin < entry.threshold;
        uint index = own ? slot : entry.alias;
        PunctualSample s;
        sample_punctual(lights[index], p, s);
        light.wi = s.wi;
        light.distance = s.distance;
        light.radiance = s.irradiance;
        light.pdf = params.punctual_range.pdf * (own ? entry.pdf_self : entry.pdf_alias);
        light.punctual = true;
        light.source = 1u + index;
    } else if (in_range(params.emitter_range, choice)) {
        uint inner = stretch_choice(params.emitter_range, choice);
        sample_emitter(inner, coin, u, v, p, light);
        light.pdf = light.pdf * params.emitter_range.pdf;
    }
}
