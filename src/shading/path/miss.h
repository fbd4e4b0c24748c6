// The miss stage: the environment, or the background for camera rays.

HM_FN void miss(HM_INOUT(PathPayload) p, vec3 direction) {
    p.hit_distance = -1.0f;
    p.passed_through = 0u;
    p.emitted = vec3(0.0f);
    p.emitted_pdf = 0.0f;
    p.weight = vec3(0.0f);
    p.light_contribution = vec3(0.0f);
#ifdef HM_AOVS
    p.emitted_source = kSourceEnvironment;
#endif
    if (p.bounce == 0u && params.background != kBackgroundEnvironment) {
        if (params.background == kBackgroundColor) p.emitted = params.background_color;
        return;
    }
    if (environment.intensity <= 0.0f) return;
    vec2 uv = environment_uv(direction);
    p.emitted = environment_radiance(uv);
    if (p.bounce > 0u) p.emitted_pdf = pdf_light_environment(direction, uv);
}
