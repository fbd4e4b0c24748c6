// The colour of a thin film on a surface, for KHR_materials_iridescence: Airy summation whose
// spectral integral is Gaussian fits of the colour matching functions in the Fourier domain
// (Belcour and Barla, "A Practical Extension to Microfacet Theory for the Modeling of Varying
// Iridescence", 2017), two orders of interference.
#ifndef HM_SHADING_MATERIAL_THIN_FILM_H
#define HM_SHADING_MATERIAL_THIN_FILM_H

#include "shading/material/fresnel.h"

HM_NAMESPACE_BEGIN

// One Gaussian of the fits: its share of a colour matching function's transform, for an optical
// path difference in metres and a phase shift in turns. `position` is in cycles per metre times 2
// pi.
HM_FN float film_gaussian(float amplitude, float position, float variance, float difference,
                          float turns) {
    float phase = 6.28318530717959f * difference;
    float angle = position * difference + turns;
    float wave = cos_sin_2pi(fract(angle)).x;
    return amplitude * fast_sqrt(6.28318530717959f * variance) * wave *
           exp(-variance * phase * phase);
}

// The response of linear Rec.709 to a path difference, per channel with its own phase shift.
HM_FN vec3 film_response(float difference, vec3 turns) {
    float x = film_gaussian(5.4856e-13f, 1.6810e6f, 4.3278e9f, difference, turns.x) +
              film_gaussian(9.7470e-14f, 2.2399e6f, 4.5282e9f, difference, turns.x);
    float y = film_gaussian(4.4201e-13f, 1.7953e6f, 9.3046e9f, difference, turns.y);
    float z = film_gaussian(5.2481e-13f, 2.2084e6f, 6.6121e9f, difference, turns.z);
    float scale = 1.0f / 1.0685e-7f;
    x = x * scale;
    y = y * scale;
    z = z * scale;
    return vec3(3.2404542f * x - 1.5371385f * y - 0.4985314f * z,
                -0.9692660f * x + 1.8760108f * y + 0.0415560f * z,
                0.0556434f * x - 0.2040259f * y + 1.0572252f * z);
}

// Of the boundary between film and base, whose index follows from its f0: reflectance at normal
// incidence, and whether the reflected wave is shifted by half a turn.
HM_FN float film_base_reflectance(float f0, float film_ior, HM_OUT(float) half_turn) {
    float root = fast_sqrt(clamp(f0, 0.0f, 0.9999f));
    float base_ior = (1.0f + root) / (1.0f - root);
    float r = (base_ior - film_ior) / (base_ior + film_ior);
    half_turn = base_ior < film_ior ? 0.5f : 0.0f;
    return r * r;
}

HM_FN vec3 schlick_color(vec3 f0, float cosine) {
    return f0 + (vec3(1.0f) - f0) * pow5(saturate(1.0f - cosine));
}

// Reflectance of a film of a thickness in nanometres, in air, on a base of reflectance f0.
HM_FN vec3 thin_film_fresnel(float film_ior, float thickness_nm, vec3 f0, float cosine) {
    HM_MAY_CONTRACT
    // A film that vanishes becomes air (KHR_materials_iridescence).
    float s = saturate(thickness_nm / 0.03f);
    float ior = 1.0f + (film_ior - 1.0f) * s * s * (3.0f - 2.0f * s);
    float cos_film;
    float r12 = fresnel_dielectric(cosine, ior, cos_film);
    if (r12 >= 1.0f) return vec3(1.0f);
    float t121 = 1.0f - r12;
    vec3 turns;
    vec3 base;
    base.x = film_base_reflectance(f0.x, ior, turns.x);
    base.y = film_base_reflectance(f0.y, ior, turns.y);
    base.z = film_base_reflectance(f0.z, ior, turns.z);
    vec3 r23 = schlick_color(base, cos_film);
    turns = turns + vec3(ior < 1.0f ? 0.0f : 0.5f);
    float difference = 2.0f * ior * thickness_nm * 1e-9f * cos_film;
    vec3 product = clamp(r23 * r12, vec3(1e-9f), vec3(0.9999f));
    vec3 series = r23 * (t121 * t121) / (vec3(1.0f) - product);
    vec3 order = series - vec3(t121);
    vec3 root = vec3(fast_sqrt(product.x), fast_sqrt(product.y), fast_sqrt(product.z));
    vec3 color = series + vec3(r12);
    for (uint m = 1u; m <= 2u; ++m) {
        order = order * root;
        color = color + order * film_response(float(m) * difference, turns * float(m)) * 2.0f;
    }
    return clamp(color, vec3(0.0f), vec3(1.0f));
}

HM_NAMESPACE_END

#endif
