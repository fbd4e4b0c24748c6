// Light sampling of emissive triangles: uniform over each triangle's area, with the same pdf that
// BSDF sampling computes for the same point.
#include "scene/emitters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "support/light_host.h"
#include "support/scenes.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::LightHost;
using test::SceneBuilder;

struct Found {
    std::size_t emitter;
    double t, u, v;  // ray distance; barycentrics
};

// The first emitter that a ray hits, in double. The ray was aimed at a point slightly in front of
// it, so it may narrowly miss at an edge.
std::optional<Found> intersect(const FlatScene& flat, vec3 from, vec3 towards) {
    std::optional<Found> best;
    const glm::dvec3 o(from), d(towards);
    for (std::size_t i = 0; i < flat.emitters.size(); ++i) {
        const glm::dvec3 p(flat.emitters[i].p0);
        const glm::dvec3 e1 = glm::dvec3(flat.emitters[i].p1) - p;
        const glm::dvec3 e2 = glm::dvec3(flat.emitters[i].p2) - p;
        const glm::dvec3 q = glm::cross(d, e2);
        const double det = glm::dot(e1, q);
        if (std::abs(det) < 1e-12) continue;
        const double u = glm::dot(o - p, q) / det;
        const glm::dvec3 r = glm::cross(o - p, e1);
        const double v = glm::dot(d, r) / det, t = glm::dot(e2, r) / det;
        const bool inside = u > -1e-4 && v > -1e-4 && u + v < 1 + 1e-4 && t > 0;
        if (inside && (!best || t < best->t)) best = Found{i, t, u, v};
    }
    return best;
}

// Two lamps far enough apart that no ray hits both; the second is mirrored, with four times the
// area.
SceneBuilder two_lamps(bool two_sided) {
    SceneBuilder b;
    Material m = test::emitter(vec3(2));
    m.double_sided = two_sided;
    int lamp = b.quad(vec3(-0.5f, -0.5f, 0), vec3(1, 0, 0), vec3(0, 1, 0), b.material(m));
    b.place(lamp, glm::translate(glm::mat4(1), vec3(-3, 0, 0)));
    b.place(lamp, glm::scale(glm::translate(glm::mat4(1), vec3(3, 0, 0)), vec3(-2, 2, 1)));
    return b;
}

TEST(Emitters, SamplesAreEvenOverTheirTriangles) {
    SceneBuilder b = two_lamps(false);
    FlatScene flat = test::flatten_quietly(b.scene);
    LightHost host(flat);
    test::Random random(91);
    const vec3 p(0.2f, 0.3f, 1.7f);
    constexpr std::size_t kSide = 8;
    test::Histogram histogram(flat.emitters.size() * kSide * kSide);
    for (int i = 0; i < 200000; ++i) {
        uint choice = random.bits(), coin = random.bits();
        float u = random.unit(), v = random.unit();
        LightHost::LightSample light;
        host.begin_light_sample(light);
        host.sample_emitter(choice, coin, u, v, p, light);
        ASSERT_GT(light.pdf, 0.0f);
        EXPECT_EQ(light.radiance, vec3(2));
        std::optional<Found> found = intersect(flat, p, light.wi);
        ASSERT_TRUE(found);
        // The shadow ray ends in front of the lamp.
        EXPECT_LT(double(light.distance), found->t);
        EXPECT_NEAR(double(light.distance), found->t, 1e-3);
        double a = std::clamp(1 - found->u, 1e-9, 1.0);
        std::size_t row = std::size_t(std::clamp(a * a, 0.0, 0.9999) * kSide);
        std::size_t column = std::size_t(std::clamp(found->v / a, 0.0, 0.9999) * kSide);
        histogram.add((found->emitter * kSide + row) * kSide + column);

        const EmitterTriangle& e = flat.emitters[found->emitter];
        glm::dvec3 normal = glm::cross(glm::dvec3(e.p1 - e.p0), glm::dvec3(e.p2 - e.p0));
        double area = 0.5 * glm::length(normal);
        double cosine = std::abs(glm::dot(glm::normalize(normal), glm::dvec3(light.wi)));
        double share = double(flat.emitter_alias[found->emitter].pdf_self);
        double exact = share * found->t * found->t / (area * cosine);
        EXPECT_NEAR(double(light.pdf), exact, 1e-3 * exact);
        HitIds ids{e.instance, e.geometry, e.primitive};
        uint geometry = flat.instances[e.instance].first_geometry + e.geometry;
        EXPECT_NEAR(double(host.pdf_light_triangle(ids, geometry, float(found->t), float(cosine))),
                    double(host.params.emitter_range.pdf) * exact, 1e-4 * exact);
    }
    std::vector<double> shares;
    for (const AliasEntry& entry : flat.emitter_alias)
        shares.insert(shares.end(), kSide * kSide, double(entry.pdf_self) / (kSide * kSide));
    EXPECT_GT(histogram.test(shares).p_value, test::single_level());
}

TEST(Emitters, SingleSidedLampsShineForwardsOnly) {
    for (bool two_sided : {false, true}) {
        SceneBuilder b = two_lamps(two_sided);
        FlatScene flat = test::flatten_quietly(b.scene);
        LightHost host(flat);
        test::Random random(92);
        for (float z : {1.0f, -1.0f})
            for (int i = 0; i < 1000; ++i) {
                uint choice = random.bits(), coin = random.bits();
                float u = random.unit(), v = random.unit();
                LightHost::LightSample light;
                host.begin_light_sample(light);
                host.sample_emitter(choice, coin, u, v, vec3(0, 0, z), light);
                // Both lamps face +z, the mirrored one too.
                EXPECT_EQ(light.pdf > 0, two_sided || z > 0);
            }
    }
}

TEST(Emitters, CoverageDimsMaskAndBlend) {
    for (uint mode : {kAlphaMask, kAlphaBlend}) {
        SceneBuilder b;
        Material m = test::emitter(vec3(4));
        m.alpha_mode = mode;
        m.base_color.w = 0.25f;
        b.place(b.quad(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), b.material(m)));
        FlatScene flat = test::flatten_quietly(b.scene);
        LightHost host(flat);
        LightHost::LightSample light;
        host.begin_light_sample(light);
        host.sample_emitter(0, 0, 0.5f, 0.25f, vec3(0.5f, 0.5f, 1), light);
        EXPECT_NEAR(light.radiance.x, mode == kAlphaMask ? 0.0f : 1.0f, 1e-6f);
    }
}

TEST(Emitters, KindsArePickedAsOftenAsTheirDensitySays) {
    SceneBuilder b = two_lamps(true);
    Light lamp;
    b.light(lamp, glm::translate(glm::mat4(1), vec3(0, 0, 5)));
    lamp.intensity = 3;
    b.light(lamp, glm::translate(glm::mat4(1), vec3(0, 4, 5)));
    FlatScene flat = test::flatten_quietly(b.scene, test::constant_environment(vec3(0.2f)));
    LightHost host(flat);
    test::Random random(93);
    test::Histogram histogram(4);
    for (int i = 0; i < 200000; ++i) {
        uint choice = random.bits(), coin = random.bits();
        float u = random.unit(), v = random.unit();
        LightHost::LightSample light;
        host.begin_light_sample(light);
        host.sample_light(choice, coin, u, v, vec3(0, 0, 0.5f), light);
        if (light.punctual) {
            bool second = light.wi.y > 0.1f;
            histogram.add(second ? 1 : 0);
            EXPECT_NEAR(light.pdf, host.params.punctual_range.pdf * (second ? 0.75f : 0.25f),
                        1e-6f);
        } else {
            histogram.add(light.distance < kInfinity ? 2 : 3);
        }
    }
    const RenderParams& params = host.params;
    const std::vector<double> shares = {
        double(params.punctual_range.pdf) * 0.25, double(params.punctual_range.pdf) * 0.75,
        double(params.emitter_range.pdf), double(params.environment_range.pdf)};
    EXPECT_GT(histogram.test(shares).p_value, test::single_level());
}

}  // namespace
}  // namespace hm
