// How much light a material of base colour one reflects: all of it with energy compensation, and
// for Appendix B to the letter a known excess.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/hosts.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::BsdfHost;
using test::direction;

constexpr float kRoughnesses[] = {0.0f, 0.04f, 0.07f, 0.1f,  0.15f, 0.2f,
                                  0.3f, 0.45f, 0.6f,  0.75f, 0.9f,  1.0f};
constexpr float kCosines[] = {0.05f, 0.1f, 0.2f, 0.4f, 0.7f, 1.0f};

BsdfHost::Bsdf white(BsdfHost& host, float metallic, float roughness, float weight, float cos_o) {
    BsdfHost::Bsdf b;
    host.make_bsdf({vec3(1), metallic, roughness, weight}, direction(cos_o, 0.3f), b);
    return b;
}

// Directional albedo by the material's own sampling, over points of the R3 lattice.
double sampled_albedo(BsdfHost& host, const BsdfHost::Bsdf& b, float cos_o, int count) {
    const vec3 wo = direction(cos_o, 0.3f);
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        auto lattice = [&](double step) {
            double x = 0.5 + step * i;
            return float(x - std::floor(x));
        };
        vec3 wi = host.sample_bsdf(b, wo, lattice(0.8191725133961645), lattice(0.6710436067037893),
                                   lattice(0.5497004779019703));
        float pdf;
        vec3 f = host.eval_bsdf(b, wo, wi, pdf);
        if (pdf > 0) sum += double(f.y) / double(pdf);
    }
    return sum / count;
}

// The same by even steps in cosine and azimuth, knowing nothing of the material's sampling.
double gridded_albedo(BsdfHost& host, const BsdfHost::Bsdf& b, float cos_o, int steps) {
    const vec3 wo = direction(cos_o, 0.3f);
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            // Denser towards the horizon, where rough lobes are steep: z = t^2.
            double t = (i + 0.5) / steps;
            double phi = 2 * std::numbers::pi * (j + 0.5) / steps;
            float pdf;
            vec3 f = host.eval_bsdf(b, wo, direction(float(t * t), float(phi)), pdf);
            sum += double(f.y) * 2 * t;
        }
    return sum * 2 * std::numbers::pi / (double(steps) * steps);
}

TEST(Furnace, CompensatedMaterialsReflectEverything) {
    BsdfHost host(true);
    double worst = 0;
    for (float metallic : {0.0f, 0.3f, 0.7f, 1.0f})
        for (float weight : {0.0f, 0.5f, 1.0f})
            for (float roughness : kRoughnesses)
                for (float cos_o : kCosines) {
                    BsdfHost::Bsdf b = white(host, metallic, roughness, weight, cos_o);
                    double albedo = sampled_albedo(host, b, cos_o, 8192);
                    worst = std::max(worst, std::abs(albedo - 1));
                    EXPECT_NEAR(albedo, 1, 0.01)
                        << "metallic " << metallic << ", specular weight " << weight
                        << ", roughness " << roughness << ", cos " << cos_o;
                }
    RecordProperty("largest_error", std::to_string(worst));
}

TEST(Furnace, QuadratureThatKnowsNoSamplingAgrees) {
    BsdfHost host(true);
    for (float metallic : {0.0f, 0.5f, 1.0f})
        for (float roughness : {0.55f, 0.8f, 1.0f})
            for (float cos_o : kCosines) {
                BsdfHost::Bsdf b = white(host, metallic, roughness, 1, cos_o);
                EXPECT_NEAR(gridded_albedo(host, b, cos_o, 160), 1, 0.01)
                    << "metallic " << metallic << ", roughness " << roughness << ", cos " << cos_o;
            }
}

// The cosine-weighted mean of what white metal reflects without compensation: midpoints of the
// cosine's square root and of the numbers that sample visible normals. Square roots at either end
// of the first number become smooth by u = 3t^2 - 2t^3.
double mean_single_scattering(BsdfHost& without, float roughness, int steps) {
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double root = (i + 0.5) / steps;
        const float cos_o = float(root * root);
        const vec3 wo = direction(cos_o, 0.3f);
        const BsdfHost::Bsdf b = white(without, 1, roughness, 1, cos_o);
        for (int j = 0; j < steps; ++j) {
            const double t = (j + 0.5) / steps;
            const double weight = 4 * std::pow(root, 3) * 6 * t * (1 - t);
            for (int k = 0; k < steps; ++k) {
                const vec3 wi = without.sample_bsdf(b, wo, 0, float(t * t * (3 - 2 * t)),
                                                    float((k + 0.5) / steps));
                float pdf;
                const float f = without.eval_bsdf(b, wo, wi, pdf).y;
                if (pdf > 0) sum += weight * double(f) / double(pdf);
            }
        }
    }
    return sum / std::pow(steps, 3);
}

// The same of what compensation adds: it depends on cos_o and cos_i alone, so it is read from the
// plane of wo, on its side, away from the highlight. By midpoints of the cosines' square roots.
double mean_added(BsdfHost& with, BsdfHost& without, float roughness, int steps) {
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double root_o = (i + 0.5) / steps;
        const float cos_o = float(root_o * root_o);
        const BsdfHost::Bsdf single = white(without, 1, roughness, 1, cos_o);
        const BsdfHost::Bsdf both = white(with, 1, roughness, 1, cos_o);
        const vec3 wo = direction(cos_o, 0.3f);
        for (int j = 0; j < steps; ++j) {
            const double root_i = (j + 0.5) / steps;
            const vec3 wi = direction(float(root_i * root_i), 0.3f);
            float pdf;
            const float f = with.eval_bsdf(both, wo, wi, pdf).y;
            const float f_single = without.eval_bsdf(single, wo, wi, pdf).y;
            // f cos_i, times 2 cos_o dcos_o and 2 pi dcos_i.
            sum += double(f - f_single) * 4 * std::pow(root_o, 3) * 4 * std::numbers::pi * root_i;
        }
    }
    return sum / (double(steps) * steps);
}

// The table is good to 8e-5. The midpoints leave up to 4e-5 on top of that (single scattering: 96
// steps differ from 256 by 3.1e-5, 128 from 256 by 1.2e-5; what is added: 256 from 1024 by 1.2e-5,
// where the former is small). A table of exact values at 32 x 32 nodes gained 3e-4.
TEST(Furnace, WhiteMetalNeitherGainsNorLosesOnAverage) {
    BsdfHost with(true), without(false);
    double worst = 0;
    for (int i = 0; i <= 38; ++i) {
        const float roughness = 0.05f + 0.025f * float(i);
        const double gain = mean_single_scattering(without, roughness, 96) +
                            mean_added(with, without, roughness, 256) - 1;
        worst = std::max(worst, std::abs(gain));
        EXPECT_NEAR(gain, 0, 1.2e-4) << "roughness " << roughness;
    }
    RecordProperty("largest_gain", std::to_string(worst));
}

TEST(Furnace, LambertianIsExact) {
    for (bool compensation : {true, false}) {
        BsdfHost host(compensation);
        for (float cos_o : kCosines) {
            BsdfHost::Bsdf b = white(host, 0, 0.3f, 0, cos_o);
            EXPECT_EQ(b.specular.probability, 0.0f);
            EXPECT_NEAR(sampled_albedo(host, b, cos_o, 1024), 1, 2e-6);
            float pdf;
            vec3 f = host.eval_bsdf(b, direction(cos_o, 0), direction(0.5f, 2), pdf);
            EXPECT_NEAR(f.x, 0.5f / std::numbers::pi_v<float>, 1e-7f);
        }
    }
}

TEST(Furnace, WithoutCompensationTheExcessIsTheDocumentedOne) {
    // Appendix B adds a Lambertian base that a rough or grazing specular layer does not dim enough.
    // docs/shading.md gives these numbers.
    BsdfHost host(false);
    double most_dielectric = 0, most_metal = 0, least_metal = 2;
    for (float roughness : kRoughnesses)
        for (float cos_o : kCosines) {
            BsdfHost::Bsdf dielectric = white(host, 0, roughness, 1, cos_o);
            most_dielectric =
                std::max(most_dielectric, sampled_albedo(host, dielectric, cos_o, 8192));
            BsdfHost::Bsdf metal = white(host, 1, roughness, 1, cos_o);
            double m = sampled_albedo(host, metal, cos_o, 8192);
            most_metal = std::max(most_metal, m);
            least_metal = std::min(least_metal, m);
        }
    RecordProperty("most_dielectric", std::to_string(most_dielectric));
    RecordProperty("least_metal", std::to_string(least_metal));
    EXPECT_LT(most_dielectric, 1.75);
    EXPECT_GT(most_dielectric, 1.5);
    EXPECT_LT(most_metal, 1.001);
    EXPECT_LT(least_metal, 0.6);  // single scattering loses as much
}

TEST(Furnace, NoMaterialGainsEnergyWhateverItsColour) {
    BsdfHost host(true);
    test::Random random(61);
    for (int i = 0; i < 400; ++i) {
        vec3 base(random.unit());
        float metallic = random.unit(), roughness = random.unit(), weight = random.unit();
        float cos_o = random.between(0.02f, 1);
        BsdfHost::Bsdf b;
        host.make_bsdf({base, metallic, roughness, weight}, direction(cos_o, 0.3f), b);
        double albedo = sampled_albedo(host, b, cos_o, 4096);
        EXPECT_LT(albedo, 1.01) << base.x << " " << metallic << " " << roughness << " " << cos_o;
        // A rough grey metal darkens as light meets it more than once.
        EXPECT_GT(albedo, 0.5 * double(base.x) - 0.01);
    }
}

}  // namespace
}  // namespace hm
