// Leaving a surface, and shading normals that reflect upwards.
#include "shading/geometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/statistics.h"

namespace hm {
namespace {

vec3 random_direction(test::Random& random) {
    for (;;) {
        vec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        float squared = dot(v, v);
        if (squared > 0.01f && squared < 1) return v / std::sqrt(squared);
    }
}

double dot_double(vec3 a, vec3 b) {
    return double(a.x) * double(b.x) + double(a.y) * double(b.y) + double(a.z) * double(b.z);
}

TEST(Geometry, OffsetLeavesToTheNormalsSide) {
    test::Random random(21);
    for (int exponent = -6; exponent <= 6; ++exponent)
        for (int i = 0; i < 20000; ++i) {
            float size = std::pow(10.0f, float(exponent));
            vec3 p =
                size * vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
            vec3 n = random_direction(random);
            vec3 moved = offset_ray_origin(p, n) - p;
            // Never against the normal, at least a few units in the last place of the largest
            // coordinate, and never farther than is needed.
            float largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
            EXPECT_GT(dot_double(moved, n), 0.0);
            float unit = std::max(largest * 0x1p-24f, 0x1p-24f);
            EXPECT_LT(length(moved), 700 * unit);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_GE(moved[k] * n[k], 0.0f);
        }
}

TEST(Geometry, OffsetNearTheOriginIsFixed) {
    // Where a coordinate is small its own precision says nothing of what made it: a transform of
    // metres rounds to 2^-24 m and more.
    test::Random random(24);
    for (int i = 0; i < 20000; ++i) {
        vec3 p = std::exp2(random.between(-30, -6)) * random_direction(random);
        vec3 n = random_direction(random);
        EXPECT_LT(length(offset_ray_origin(p, n) - p - n * 0x1p-16f), 1e-8f);
    }
}

TEST(Geometry, OffsetClearsThePlaneOfATriangleFarFromTheOrigin) {
    test::Random random(22);
    for (int i = 0; i < 20000; ++i) {
        vec3 center = 100.0f * random_direction(random);
        vec3 e1 = random_direction(random), e2 = random_direction(random);
        vec3 n = cross(e1, e2);
        if (length(n) < 0.2f) continue;
        n = normalize(n);
        float u = random.unit(), v = random.unit() * (1 - u);
        vec3 q = center * (1 - u - v) + (center + e1) * u + (center + e2) * v;
        EXPECT_GT(dot_double(offset_ray_origin(q, n) - center, n), 0.0);
        EXPECT_LT(dot_double(offset_ray_origin(q, -n) - center, n), 0.0);
    }
}

TEST(Geometry, BentNormalReflectsAboveTheSurface) {
    test::Random random(23);
    const vec3 ng(0, 0, 1);
    int bent_count = 0;
    for (int i = 0; i < 200000; ++i) {
        vec3 wo = random_direction(random);
        vec3 ns = random_direction(random);
        wo.z = std::abs(wo.z) * std::exp2(random.between(-24, 0));
        ns.z = std::abs(ns.z);
        if (wo.z == 0) continue;
        wo = normalize(wo);
        vec3 bent = bend_shading_normal(ns, ng, wo);
        vec3 mirrored = 2.0f * dot(wo, bent) * bent - wo;
        ASSERT_TRUE(std::isfinite(bent.x) && std::isfinite(bent.y) && std::isfinite(bent.z));
        EXPECT_NEAR(length(bent), 1.0f, 1e-5f);
        EXPECT_GT(dot(bent, wo), 0.0f);
        EXPECT_GT(mirrored.z, 0.5f * kMirrorClearance);
        bool cleared = (2.0f * dot(wo, ns) * ns - wo).z >= kMirrorClearance;
        EXPECT_TRUE(!cleared || bent == ns);
        bent_count += cleared ? 0 : 1;
    }
    EXPECT_GT(bent_count, 10000);
}

TEST(Geometry, BentNormalAtTheEdges) {
    const vec3 ng(0, 0, 1);
    for (vec3 wo : {vec3(1, 0, 0), normalize(vec3(1, 0, 1e-30f)), normalize(vec3(-1, 0, 1e-7f)),
                    vec3(0, 0, 1), normalize(vec3(0.6f, 0.8f, 1e-4f))})
        for (vec3 ns : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1),
                        normalize(vec3(-1, 0, 1e-6f))}) {
            vec3 bent = bend_shading_normal(ns, ng, wo);
            EXPECT_NEAR(length(bent), 1.0f, 1e-5f) << wo.x << " " << wo.z << " " << ns.x;
            EXPECT_GE(dot(bent, wo), 0.0f);
        }
}

}  // namespace
}  // namespace hm
