// Encodings and tone curves. Linear values are Rec.709, sRGB is IEC 61966-2-1.
#ifndef HM_SHADING_COLOR_H
#define HM_SHADING_COLOR_H

#include "shading/math.h"

HM_NAMESPACE_BEGIN

HM_CONST uint kToneLinear = 0u;
HM_CONST uint kToneAces = 1u;
HM_CONST uint kToneAgx = 2u;
HM_CONST uint kToneNeutral = 3u;

HM_FN float srgb_to_linear(float x) {
    HM_MAY_CONTRACT
    return x <= 0.04045f ? x * (1.0f / 12.92f) : pow((x + 0.055f) * (1.0f / 1.055f), 2.4f);
}

HM_FN float linear_to_srgb(float x) {
    return x <= 0.0031308f ? x * 12.92f : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}

HM_FN vec3 linear_to_srgb3(vec3 c) {
    return vec3(linear_to_srgb(c.x), linear_to_srgb(c.y), linear_to_srgb(c.z));
}

// Khronos PBR Neutral (specification of 2024): hue-preserving, 1:1 below 0.8 less the Fresnel toe.
HM_FN vec3 tone_neutral(vec3 color) {
    float start = 0.8f - 0.04f;
    float desaturation = 0.15f;
    float low = min(color.x, min(color.y, color.z));
    float offset = low < 0.08f ? low - 6.25f * low * low : 0.04f;
    vec3 c = color - offset;
    float peak = max_component(c);
    if (peak < start) return c;
    float d = 1.0f - start;
    float new_peak = 1.0f - d * d / (peak + d - start);
    c = c * (new_peak / peak);
    float g = 1.0f - 1.0f / (desaturation * (peak - new_peak) + 1.0f);
    return mix(c, vec3(new_peak), g);
}

// ACES RRT and ODT for sRGB, the fit of Stephen Hill (BakingLab).
HM_FN vec3 tone_aces(vec3 color) {
    vec3 c = vec3(0.59719f * color.x + 0.35458f * color.y + 0.04823f * color.z,
                  0.07600f * color.x + 0.90834f * color.y + 0.01566f * color.z,
                  0.02840f * color.x + 0.13383f * color.y + 0.83777f * color.z);
    c = (c * (c + 0.0245786f) - 0.000090537f) / (c * (0.983729f * c + 0.4329510f) + 0.238081f);
    return vec3(1.60475f * c.x - 0.53108f * c.y - 0.07367f * c.z,
                -0.10208f * c.x + 1.10813f * c.y - 0.00605f * c.z,
                -0.00327f * c.x - 0.07276f * c.y + 1.07602f * c.z);
}

HM_FN float agx_contrast(float x) {
    // Sixth-order fit of AgX's default contrast curve over [0, 1] (Wrensch, "Minimal AgX
    // Implementation", 2023).
    float x2 = x * x;
    float x4 = x2 * x2;
    return 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 +
           0.1191f * x - 0.00232f;
}

HM_FN float agx_log_encode(float x) {
    // Stops from -12.47393 to 4.026069 around middle grey, mapped to [0, 1].
    float stops = clamp(log2(max(x, 1e-10f)), -12.47393f, 4.026069f);
    return agx_contrast((stops + 12.47393f) / 16.5f);
}

// AgX (Sobotka 2022), base look; returns linear values.
HM_FN vec3 tone_agx(vec3 color) {
    vec3 c =
        vec3(0.842479062253094f * color.x + 0.0784335999999992f * color.y +
                 0.0792237451477643f * color.z,
             0.0423282422610123f * color.x + 0.878468636469772f * color.y +
                 0.0791661274605434f * color.z,
             0.0423756549057051f * color.x + 0.0784336f * color.y + 0.879142973793104f * color.z);
    c = vec3(agx_log_encode(c.x), agx_log_encode(c.y), agx_log_encode(c.z));
    vec3 d = vec3(1.19687900512017f * c.x - 0.0980208811401368f * c.y - 0.0990297440797205f * c.z,
                  -0.0528968517574562f * c.x + 1.15190312990417f * c.y - 0.0989611768448433f * c.z,
                  -0.0529716355144438f * c.x - 0.0980434501171241f * c.y + 1.15107367264116f * c.z);
    d = max(d, vec3(0.0f));
    return vec3(pow(d.x, 2.2f), pow(d.y, 2.2f), pow(d.z, 2.2f));
}

// Scene radiance to display-linear values in [0, 1]. `curve` is kTone*.
HM_FN vec3 tone_map(vec3 radiance, uint curve) {
    vec3 c = max(radiance, vec3(0.0f));
    if (curve == kToneAces) {
        c = tone_aces(c);
    } else if (curve == kToneAgx) {
        c = tone_agx(c);
    } else if (curve == kToneNeutral) {
        c = tone_neutral(c);
    }
    return clamp(c, vec3(0.0f), vec3(1.0f));
}

HM_NAMESPACE_END

#endif
