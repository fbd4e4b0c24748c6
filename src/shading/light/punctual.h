// Punctual lights as KHR_lights_punctual defines them.
#ifndef HM_SHADING_LIGHT_PUNCTUAL_H
#define HM_SHADING_LIGHT_PUNCTUAL_H

#include "shading/geometry.h"
#include "shading/math.h"
#include "shading/structs.h"

HM_NAMESPACE_BEGIN

struct PunctualSample {
    vec3 wi;          // unit, towards the light
    float distance;   // of the shadow ray; kInfinity for a directional light
    vec3 irradiance;  // on a surface facing the light
};

// The extension's recommended falloff: inverse square, windowed to zero at the light's range.
HM_FN float punctual_falloff(float distance_squared, float range) {
    if (range <= 0.0f) return 1.0f / distance_squared;
    float ratio = distance_squared / (range * range);
    return saturate(1.0f - ratio * ratio) / distance_squared;
}

HM_FN void sample_punctual(HM_IN(LightData) light, vec3 p, HM_OUT(PunctualSample) s) {
    if (light.kind == kLightDirectional) {
        s.wi = -light.direction;
        s.distance = kInfinity;
        s.irradiance = light.color;
        return;
    }
    vec3 to_light = light.position - p;
    float distance_squared = max(dot(to_light, to_light), 1e-36f);
    s.distance = sqrt(distance_squared);
    s.wi = to_light * divide(1.0f, s.distance);
    float attenuation = punctual_falloff(distance_squared, light.range);
    if (light.kind == kLightSpot) {
        float cone = saturate(-dot(light.direction, s.wi) * light.spot_scale + light.spot_offset);
        attenuation = attenuation * cone * cone;
    }
    s.irradiance = light.color * attenuation;
    if (light.surface_error > 0.0f) {
        float end = ray_end_error(light.surface_error, light.surface_normal, s.wi, s.distance);
        s.distance = max(s.distance - end, 0.0f);
    }
}

HM_NAMESPACE_END

#endif
