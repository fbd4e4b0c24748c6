// GGX against a restatement in double from Heitz (2014), and its sampling against its density.
#include "shading/material/ggx.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/half_vector_grid.h"
#include "support/hosts.h"
#include "support/statistics.h"

namespace hm {
namespace {

constexpr float kCosines[] = {1.0f, 0.9f, 0.5f, 0.1f, 0.01f};
constexpr float kAlphas[] = {0.0016f, 0.01f, 0.09f, 0.36f, 1.0f};

// D from its angle, and V = G2 / (4 cos cos) with G2 = 1 / (1 + Lambda_o + Lambda_i).
double ggx_d(double cos_h, double alpha) {
    double cos2 = cos_h * cos_h, tan2 = (1 - cos2) / cos2;
    double root = cos2 * (alpha * alpha + tan2);
    return alpha * alpha / (std::numbers::pi * root * root);
}

double smith_lambda(double cos_theta, double alpha) {
    double tan2 = (1 - cos_theta * cos_theta) / (cos_theta * cos_theta);
    return 0.5 * (std::sqrt(1 + alpha * alpha * tan2) - 1);
}

TEST(Ggx, AgreesWithTheFormulasInDouble) {
    test::Random random(41);
    for (int i = 0; i < 200000; ++i) {
        float alpha = std::max(0.0016f, random.unit() * random.unit());
        // Half vectors as dense at the peak as elsewhere.
        float slope = alpha * std::exp2(random.between(-6, 6));
        float hz = 1 / std::sqrt(1 + slope * slope), phi = random.between(0, 6.28f);
        vec3 h(slope * hz * std::cos(phi), slope * hz * std::sin(phi), hz);
        // The exact cosine of the float vector, without the cancellation in 1 - z^2.
        double sin2 = double(h.x) * double(h.x) + double(h.y) * double(h.y);
        double cos_h = double(h.z) / std::sqrt(sin2 + double(h.z) * double(h.z));
        double d = ggx_d(cos_h, double(alpha));
        EXPECT_NEAR(double(eval_ggx_d(h, alpha)), d, 2e-5 * d);
        float co = random.between(1e-3f, 1), ci = random.between(1e-3f, 1);
        double v = 1 / (1 + smith_lambda(double(co), double(alpha)) +
                        smith_lambda(double(ci), double(alpha)));
        v /= 4 * double(co) * double(ci);
        EXPECT_NEAR(double(eval_ggx_v(co, ci, alpha)), v, 1e-5 * v);
    }
}

TEST(Ggx, NormalsProjectToOne) {
    // The integral of D(h) cos h over the hemisphere, in slopes: dh cos h = hz^4 dp dq.
    for (float alpha : kAlphas) {
        double sum = 0;
        constexpr int kSteps = 4000;
        for (int i = 0; i < kSteps; ++i) {
            double t = (i + 0.5) / kSteps, r2 = t / (1 - t);  // share of the mass, squared slope
            double slope = double(alpha) * std::sqrt(r2), hz = 1 / std::sqrt(1 + slope * slope);
            double dr2 = 1 / ((1 - t) * (1 - t)) / kSteps;
            vec3 h(float(slope * hz), 0, float(hz));
            sum += double(eval_ggx_d(h, alpha)) * std::pow(hz, 4) * double(alpha) * double(alpha) *
                   std::numbers::pi * dr2;
        }
        EXPECT_NEAR(sum, 1, 1e-4) << alpha;
    }
}

// The direction on the unit sphere whose mirror half with wo_std is the stretched h.
glm::dvec3 cap_point(glm::dvec3 h, glm::dvec3 wo_std, double alpha) {
    glm::dvec3 m = glm::normalize(glm::dvec3(h.x / alpha, h.y / alpha, h.z));
    return 2 * glm::dot(wo_std, m) * m - wo_std;
}

float pdf_ggx_reflection(vec3 wo, vec3 h, float alpha) {
    return eval_ggx_d(h, alpha) * ggx_reflection_pdf_scale(wo, alpha);
}

TEST(Ggx, BoundedCapLosesNothingAboveTheHorizon) {
    // Integrates the density over all half vectors, in double, splitting what bounded sampling can
    // reach from what it leaves out. The reachable part has mass one; the rest points downwards.
    for (float cos_o : kCosines)
        for (float alpha : kAlphas) {
            vec3 wo = test::direction(cos_o, 0.4f);
            glm::dvec3 o(wo),
                std_o = glm::normalize(glm::dvec3(o.x * double(alpha), o.y * double(alpha), o.z));
            double lower = double(ggx_cap_scale(wo, std::hypot(wo.x, wo.y), alpha)) * std_o.z;
            double mass = 0;
            constexpr int kRings = 500, kSectors = 1000;
            for (int i = 0; i < kRings; ++i)
                for (int j = 0; j < kSectors; ++j) {
                    double t = (i + 0.5) / kRings, r2 = t / (1 - t);
                    double phi = 2 * std::numbers::pi * (j + 0.5) / kSectors;
                    double slope = double(alpha) * std::sqrt(r2);
                    double hz = 1 / std::sqrt(1 + slope * slope);
                    glm::dvec3 h(slope * hz * std::cos(phi), slope * hz * std::sin(phi), hz);
                    double cos_d = glm::dot(o, h);
                    if (cos_d <= 0) continue;
                    if (cap_point(h, std_o, double(alpha)).z < -lower) {
                        EXPECT_LE(2 * cos_d * h.z - o.z, 1e-4) << cos_o << " " << alpha;
                        continue;
                    }
                    double area = hz * hz * hz * double(alpha) * double(alpha) * 0.5 /
                                  ((1 - t) * (1 - t)) / kRings * 2 * std::numbers::pi / kSectors;
                    mass += 4 * cos_d * area * double(pdf_ggx_reflection(wo, vec3(h), alpha));
                }
            EXPECT_NEAR(mass, 1, 0.015) << "cos " << cos_o << ", alpha " << alpha;
        }
}

TEST(Ggx, SamplesMatchTheirDensity) {
    constexpr int kSamples = 150000;
    test::Random random(42);
    for (float cos_o : kCosines)
        for (float alpha : kAlphas) {
            vec3 wo = test::direction(cos_o, 0.4f);
            test::HalfVectorGrid grid(wo, alpha);
            test::Histogram histogram(grid.kBins);
            for (int i = 0; i < kSamples; ++i) {
                float u = random.unit(), v = random.unit();
                vec3 wi = sample_ggx_reflection(wo, alpha, u, v);
                ASSERT_NEAR(length(wi), 1.0f, 1e-5f);
                if (wi.z > 0)
                    histogram.add(grid.bin(wi));
                else
                    histogram.add_rest();  // below the horizon
            }
            std::vector<double> shares =
                grid.integrate(20, [&](vec3, vec3 h) { return pdf_ggx_reflection(wo, h, alpha); });
            test::ChiSquare fit = histogram.test(shares);
            EXPECT_GT(fit.p_value, test::single_level())
                << "cos " << cos_o << ", alpha " << alpha << ": chi squared " << fit.statistic
                << " of " << fit.degrees << ", below " << histogram.rest;
        }
}

TEST(Ggx, MirrorLikeSamplesStayAtTheMirrorDirection) {
    test::Random random(43);
    for (float cos_o : kCosines) {
        vec3 wo = test::direction(cos_o, 1.0f);
        vec3 mirror(-wo.x, -wo.y, wo.z);
        int near = 0;
        for (int i = 0; i < 10000; ++i) {
            float u = random.unit(), v = random.unit();
            near += length(sample_ggx_reflection(wo, 0.0016f, u, v) - mirror) < 0.05f ? 1 : 0;
        }
        EXPECT_GT(near, 9900) << cos_o;
    }
}

}  // namespace
}  // namespace hm
