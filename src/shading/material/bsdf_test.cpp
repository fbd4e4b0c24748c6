// The material against glTF 2.0 Appendix B restated in double, its symmetry, and its sampling.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/half_vector_grid.h"
#include "support/hosts.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::BsdfHost;
using test::direction;

vec3 random_upper(test::Random& random, float lowest_cosine) {
    float z = random.between(lowest_cosine, 1), phi = random.between(0, 6.2831853f);
    return direction(z, phi);
}

// A direction near the mirror of wo, as likely off the peak as on it for any roughness.
vec3 near_mirror(test::Random& random, vec3 wo, float alpha) {
    for (;;) {
        float slope = alpha * std::exp2(random.between(-4, 4));
        float phi = random.between(0, 6.2831853f);
        vec3 h = normalize(vec3(slope * std::cos(phi), slope * std::sin(phi), 1));
        vec3 wi = normalize(2 * dot(wo, h) * h - wo);
        if (wi.z > 0.01f) return wi;
        alpha *= 0.7f;
    }
}

struct Appendix {
    glm::dvec3 base;
    double metallic, roughness, specular_weight;

    // f cos as the appendix writes it: mix(dielectric_brdf, metal_brdf, metallic).
    glm::dvec3 eval(vec3 wo_float, vec3 wi_float) const {
        const glm::dvec3 v = glm::normalize(glm::dvec3(wo_float));
        const glm::dvec3 l = glm::normalize(glm::dvec3(wi_float));
        const glm::dvec3 h = glm::normalize(v + l);
        const double a2 = std::pow(roughness, 4), pi = std::numbers::pi;
        // D in the form without cancellation; V as two visibility terms.
        const double sin2_h = h.x * h.x + h.y * h.y;
        const double spread = sin2_h + a2 * h.z * h.z;
        const double d = a2 / (pi * spread * spread);
        const double vl = std::sqrt(a2 + (1 - a2) * l.z * l.z);
        const double vv = std::sqrt(a2 + (1 - a2) * v.z * v.z);
        const double specular = d * 0.5 / (l.z * vv + v.z * vl);
        const double grazing = std::pow(1 - std::abs(glm::dot(v, h)), 5);
        const glm::dvec3 metal = specular * (base + (1.0 - base) * grazing);
        const double fr = specular_weight * (0.04 + (1 - 0.04) * grazing);
        const glm::dvec3 dielectric = base / pi * (1 - fr) + glm::dvec3(specular * fr);
        return (dielectric * (1 - metallic) + metal * metallic) * l.z;
    }
};

TEST(Bsdf, IsAppendixBWithoutCompensation) {
    test::Random random(51);
    BsdfHost host(false);
    double worst = 0;
    for (int i = 0; i < 1000000; ++i) {
        vec3 base(random.unit(), random.unit(), random.unit());
        float metallic = i % 3 == 0 ? 0.0f : i % 3 == 1 ? 1.0f : random.unit();
        float roughness = random.between(0.1f, 1.0f);
        float weight = i % 5 == 0 ? random.unit() : 1.0f;
        vec3 wo = random_upper(random, 0.01f);
        vec3 wi = i % 2 == 0 ? random_upper(random, 0.01f)
                             : near_mirror(random, wo, roughness * roughness);
        BsdfHost::Bsdf b;
        host.make_bsdf({base, metallic, roughness, weight}, wo, b);
        float pdf;
        glm::dvec3 f(host.eval_bsdf(b, wo, wi, pdf));
        glm::dvec3 exact =
            Appendix{glm::dvec3(base), double(metallic), double(roughness), double(weight)}.eval(
                wo, wi);
        // What is known of the half vector from float directions, in widths of the lobe.
        double blur = 1e-7 / double(b.specular.alpha * length(wo + wi));
        for (std::size_t k = 0; k < 3; ++k)
            worst = std::max(worst, std::abs(f[k] - exact[k]) / exact[k] / (1e-5 + 4 * blur));
    }
    EXPECT_LT(worst, 1);
}

TEST(Bsdf, SmoothestIsAppendixBAtRoughnessFourHundredths) {
    // A float half vector is known to 6e-8, a lobe of alpha 0.0016 moves by 4e-5 widths with it.
    test::Random random(52);
    BsdfHost host(false);
    for (int i = 0; i < 100000; ++i) {
        vec3 wo = random_upper(random, 0.05f);
        vec3 wi = near_mirror(random, wo, 0.0016f);
        BsdfHost::Bsdf b;
        host.make_bsdf({vec3(0.9f), 1, i % 2 == 0 ? 0.0f : 0.04f, 1}, wo, b);
        float pdf;
        double f = double(host.eval_bsdf(b, wo, wi, pdf).x);
        double exact = Appendix{glm::dvec3(double(0.9f)), 1, 0.04, 1}.eval(wo, wi).x;
        EXPECT_NEAR(f, exact, 2e-3 * exact + 1e-6);
    }
}

TEST(Bsdf, IsReciprocal) {
    test::Random random(53);
    for (bool compensation : {true, false}) {
        BsdfHost host(compensation);
        double worst = 0;
        for (int i = 0; i < 200000; ++i) {
            vec3 base(random.unit(), random.unit(), random.unit());
            float metallic = random.unit(), roughness = random.between(0.04f, 1.0f);
            float weight = random.unit();
            vec3 a = random_upper(random, 0.01f);
            vec3 c = i % 2 == 0 ? random_upper(random, 0.01f)
                                : near_mirror(random, a, roughness * roughness);
            BsdfHost::Bsdf b;
            float pdf;
            host.make_bsdf({base, metallic, roughness, weight}, a, b);
            vec3 forward = host.eval_bsdf(b, a, c, pdf) / c.z;
            host.make_bsdf({base, metallic, roughness, weight}, c, b);
            vec3 backward = host.eval_bsdf(b, c, a, pdf) / a.z;
            for (std::size_t k = 0; k < 3; ++k)
                worst = std::max(worst, double(std::abs(forward[k] - backward[k]) /
                                               std::max(forward[k], 1e-6f)));
        }
        EXPECT_LT(worst, 1e-4) << "compensation " << compensation;
    }
}

TEST(Bsdf, NothingBelowTheHorizon) {
    BsdfHost host(true);
    BsdfHost::Bsdf b;
    host.make_bsdf({vec3(0.5f), 0.5f, 0.5f, 1}, direction(0.5f, 0), b);
    float pdf = 1;
    EXPECT_EQ(host.eval_bsdf(b, direction(0.5f, 0), direction(-0.1f, 2), pdf), vec3(0));
    EXPECT_EQ(pdf, 0.0f);
    EXPECT_EQ(host.eval_bsdf(b, direction(-0.5f, 0), direction(0.1f, 2), pdf), vec3(0));
    EXPECT_EQ(pdf, 0.0f);
}

struct Look {
    const char* name;
    float metallic, specular_weight;
};
constexpr Look kLooks[] = {{"dielectric", 0, 1},
                           {"metal", 1, 1},
                           {"mixed", 0.5f, 1},
                           {"half specular", 0.3f, 0.5f},
                           {"Lambertian", 0, 0}};

TEST(Bsdf, SamplesMatchTheMixturesDensity) {
    constexpr int kSamples = 60000;
    test::Random random(54);
    for (bool compensation : {true, false})
        for (const Look& look : kLooks)
            for (float roughness : {0.04f, 0.2f, 0.5f, 1.0f})
                for (float cos_o : {1.0f, 0.4f, 0.05f}) {
                    BsdfHost host(compensation);
                    vec3 wo = direction(cos_o, 2.0f);
                    BsdfHost::Bsdf b;
                    host.make_bsdf(
                        {vec3(0.8f, 0.4f, 0.1f), look.metallic, roughness, look.specular_weight},
                        wo, b);
                    test::HalfVectorGrid grid(wo, b.specular.alpha);
                    test::Histogram histogram(grid.kBins);
                    for (int i = 0; i < kSamples; ++i) {
                        float lobe = random.unit(), u = random.unit(), v = random.unit();
                        vec3 wi = host.sample_bsdf(b, wo, lobe, u, v);
                        if (wi.z > 0)
                            histogram.add(grid.bin(wi));
                        else
                            histogram.add_rest();
                    }
                    std::vector<double> shares = grid.integrate(12, [&](vec3 wi, vec3) {
                        float pdf;
                        host.eval_bsdf(b, wo, wi, pdf);
                        return pdf;
                    });
                    test::ChiSquare fit = histogram.test(shares);
                    EXPECT_GT(fit.p_value, test::single_level())
                        << look.name << ", roughness " << roughness << ", cos " << cos_o
                        << ", compensation " << compensation << ": chi squared " << fit.statistic
                        << " of " << fit.degrees << ", below " << histogram.rest;
                }
}

}  // namespace
}  // namespace hm
