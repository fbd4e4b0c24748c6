// Elementary functions against the standard library in double, frames, and the MIS weight.
#include "shading/math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shading/frame.h"
#include "support/statistics.h"

namespace hm {
namespace {

TEST(Math, CosSinWithinTwoTenMillionths) {
    double worst = 0;
    for (int i = 0; i <= 1 << 20; ++i) {
        float u = float(i) * 0x1p-20f;
        vec2 t = cos_sin_2pi(u);
        double angle = 2 * std::numbers::pi * double(u);
        worst = std::max({worst, std::abs(double(t.x) - std::cos(angle)),
                          std::abs(double(t.y) - std::sin(angle))});
    }
    EXPECT_LT(worst, 2e-7);
}

TEST(Math, CosSinQuarterTurnsAreExact) {
    EXPECT_EQ(cos_sin_2pi(0.0f), vec2(1, 0));
    EXPECT_EQ(cos_sin_2pi(0.25f), vec2(0, 1));
    EXPECT_EQ(cos_sin_2pi(0.5f), vec2(-1, 0));
    EXPECT_EQ(cos_sin_2pi(0.75f), vec2(0, -1));
    EXPECT_EQ(cos_sin_2pi(1.0f), vec2(1, 0));
}

TEST(Math, AtanWithinOneTenMillionth) {
    test::Random random(11);
    double worst = 0;
    for (int i = 0; i < 1000000; ++i) {
        float x = random.between(-1, 1) * std::exp2(random.between(-40, 40));
        float y = random.between(-1, 1) * std::exp2(random.between(-40, 40));
        double exact = std::atan2(double(y), double(x)) / (2 * std::numbers::pi);
        worst = std::max(worst, std::abs(double(atan2_over_2pi(y, x)) - exact));
    }
    EXPECT_LT(worst, 1e-7);
    EXPECT_EQ(atan2_over_2pi(0, 0), 0.0f);
    EXPECT_EQ(atan2_over_2pi(0, -1), 0.5f);
    EXPECT_EQ(atan2_over_2pi(1, 0), 0.25f);
    EXPECT_EQ(atan2_over_2pi(-1, 0), -0.25f);
}

TEST(Math, IntegersBecomeFloatsBelowOne) {
    EXPECT_EQ(unit_float(0), 0.0f);
    EXPECT_EQ(unit_float(0xffffffffu), 1.0f - 0x1p-24f);
    EXPECT_EQ(unit_float(0x80000000u), 0.5f);
    EXPECT_EQ(mul_high(0xffffffffu, 7), 6u);
    EXPECT_EQ(mul_high(0x80000000u, 10), 5u);
    EXPECT_EQ(reverse_bits(1), 0x80000000u);
    EXPECT_EQ(reverse_bits(0x12345678u), 0x1e6a2c48u);
}

TEST(Math, MisWeightsSumToOne) {
    test::Random random(12);
    for (int i = 0; i < 100000; ++i) {
        float a = std::exp2(random.between(-60, 60));
        float b = std::exp2(random.between(-60, 60));
        EXPECT_NEAR(mis_weight(a, b) + mis_weight(b, a), 1.0f, 2e-7f);
        EXPECT_NEAR(double(mis_weight(a, b)),
                    double(a) * double(a) / (double(a) * double(a) + double(b) * double(b)), 1e-6);
    }
    EXPECT_EQ(mis_weight(0, 1), 0.0f);
    EXPECT_EQ(mis_weight(0, 0), 0.0f);
    EXPECT_EQ(mis_weight(1, 0), 1.0f);
    EXPECT_EQ(mis_weight(1, INFINITY), 0.0f);
    EXPECT_EQ(mis_weight(INFINITY, 1), 1.0f);
}

void expect_orthonormal(vec3 n) {
    Frame f;
    make_frame(n, f);
    SCOPED_TRACE(testing::Message() << n.x << " " << n.y << " " << n.z);
    EXPECT_NEAR(length(f.s), 1.0f, 1e-6f);
    EXPECT_NEAR(length(f.t), 1.0f, 1e-6f);
    EXPECT_NEAR(dot(f.s, f.t), 0.0f, 1e-6f);
    EXPECT_NEAR(dot(f.s, n), 0.0f, 1e-6f);
    EXPECT_NEAR(dot(f.t, n), 0.0f, 1e-6f);
    EXPECT_GT(dot(cross(f.s, f.t), n), 0.999f);
    vec3 v(0.3f, -0.7f, 0.2f);
    EXPECT_LT(length(to_world(f, to_local(f, v)) - v), 1e-6f);
}

TEST(Frame, OrthonormalAndRightHanded) {
    test::Random random(13);
    for (int i = 0; i < 20000; ++i) {
        vec3 n(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        if (length(n) > 0.1f) expect_orthonormal(normalize(n));
    }
    for (float z : {1.0f, -1.0f})
        expect_orthonormal(vec3(0, 0, z));
    for (float z : {0.0f, -0.0f, 1e-30f, -1e-30f})
        for (vec3 n : {vec3(1, 0, z), vec3(0, -1, z), vec3(0.6f, 0.8f, z)})
            expect_orthonormal(n);
    expect_orthonormal(normalize(vec3(1e-4f, 1e-4f, -1.0f)));
    expect_orthonormal(normalize(vec3(1e-8f, -1e-8f, -1.0f)));
}

}  // namespace
}  // namespace hm
