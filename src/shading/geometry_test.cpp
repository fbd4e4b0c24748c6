// Leaving a surface, and shading normals that reflect upwards.
#include "shading/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
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

// A point interpolated on a triangle leaves the triangle's plane by its error, wherever the
// triangle is and whatever its size; and the error is no larger than rounding explains.
TEST(Geometry, HitErrorClearsThePlaneAtEverySizeAndDistance) {
    test::Random random(22);
    for (int i = 0; i < 200000; ++i) {
        const float size = std::pow(10.0f, random.between(-6, 9));
        const float distance = size * std::pow(10.0f, random.between(-3, 4));
        const vec3 center = distance * random_direction(random);
        const vec3 b = center + size * random_direction(random);
        const vec3 c = center + size * random_direction(random);
        const vec3 normal = cross(b - center, c - center);
        if (length(normal) < 0.2f * size * size) continue;
        const vec3 n = normalize(normal);
        const float u = random.unit(), v = random.unit() * (1 - u);
        const vec3 q = center * (1 - u - v) + b * u + c * v;
        const float extent = 2 * size;
        const float error = hit_error(abs(q), extent, n);
        EXPECT_GT(dot_double(q + n * error - center, n), 0.0);
        EXPECT_LT(dot_double(q - n * error - center, n), 0.0);
        EXPECT_LT(error, 0x1p-24f * (35 * distance + 36 * 2 * size));
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
