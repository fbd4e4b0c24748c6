// The BSDF of the glTF metallic-roughness material (glTF 2.0, Appendix B): the mixture of its
// lobes, each in a file of its own. Directions are local, z along the shading normal.

// What lobes are evaluated from, for one pair of directions above the surface.
struct ScatterAngles {
    float cos_o;    // of wo to the normal
    float cos_i;    // of wi to the normal
    float cos_d;    // of either to the half vector
    float grazing;  // (1 - cos_d)^5, Schlick's weight of f90
};

// clang-format off
#include "shading/material/albedo.h"
#include "shading/material/specular.h"
#include "shading/material/diffuse.h"
// clang-format on

struct Bsdf {
    SpecularLobe specular;
    DiffuseLobe diffuse;
};

// wo: the view direction, above the surface. Lobes are sampled by their share of the albedo; the
// specular lobe's multiple scattering counts with the diffuse lobe, whose cosine samples it.
HM_FN void make_bsdf(HM_IN(MaterialPoint) m, vec3 wo, HM_OUT(Bsdf) b) {
    HM_MAY_CONTRACT
    make_specular(m, wo, b.specular);
    make_diffuse(m, b.diffuse);
    vec2 e = lookup_albedo(wo.z, b.specular.roughness);
    vec3 multiple = vec3(0.0f);
    if (params.energy_compensation != 0u) {
        vec2 average = lookup_albedo_average(b.specular.roughness);
        compensate_diffuse(e, average, b.diffuse);
        multiple = compensate_specular(m, e.x + e.y, average.x + average.y,
                                       b.diffuse.layer_multiple, b.specular);
    }
    float s = luminance(albedo_specular(b.specular, e));
    float d = luminance(albedo_diffuse(b.diffuse, e) + multiple);
    float p = d > 0.0f ? 0.0f : 1.0f;
    if (s > 0.0f && d > 0.0f) p = clamp(s / (s + d), 0.01f, 0.99f);
    b.specular.probability = p;
    b.diffuse.probability = 1.0f - p;
}

// f of each lobe, without the cosine, and the density of sampling wi from all of them. The
// directions are above the surface.
HM_FN void eval_lobes(HM_IN(Bsdf) b, vec3 wo, vec3 wi, HM_OUT(vec3) diffuse, HM_OUT(vec3) specular,
                      HM_OUT(float) pdf) {
    HM_MAY_CONTRACT
    vec3 h = fast_normalize(wo + wi);
    ScatterAngles angles;
    angles.cos_o = wo.z;
    angles.cos_i = wi.z;
    angles.cos_d = saturate(dot(wo, h));
    angles.grazing = pow5(1.0f - angles.cos_d);
    vec2 e = vec2(0.0f);
    float loss = 0.0f;
    if (params.energy_compensation != 0u) {
        e = lookup_albedo(wi.z, b.specular.roughness);
        loss = 1.0f - (e.x + e.y);
    }
    float density = b.specular.probability > 0.0f ? eval_ggx_d(h, b.specular.alpha) : 0.0f;
    specular = eval_specular(b.specular, angles, density, loss);
    diffuse = eval_diffuse(b.diffuse, angles, b.specular.roughness, e, loss);
    pdf = pdf_specular(b.specular, density) + pdf_diffuse(b.diffuse, wi.z);
}

// f cos for wi, and the density of sampling it. Zero when either direction is below the surface.
HM_FN vec3 eval_bsdf(HM_IN(Bsdf) b, vec3 wo, vec3 wi, HM_OUT(float) pdf) {
    pdf = 0.0f;
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    vec3 diffuse;
    vec3 specular;
    eval_lobes(b, wo, wi, diffuse, specular, pdf);
    return (specular + diffuse) * wi.z;
}

// The diffuse lobe's part of f, 0 where there is none.
HM_FN vec3 diffuse_share(HM_IN(Bsdf) b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    vec3 diffuse;
    vec3 specular;
    float pdf;
    eval_lobes(b, wo, wi, diffuse, specular, pdf);
    return diffuse / max(specular + diffuse, vec3(1e-30f));
}

// A direction from the mixture of lobes; may point below the surface, where eval_bsdf gives zero.
HM_FN vec3 sample_bsdf(HM_IN(Bsdf) b, vec3 wo, float lobe, float u, float v) {
    if (lobe < b.specular.probability) return sample_specular(b.specular, wo, u, v);
    return sample_diffuse(u, v);
}
