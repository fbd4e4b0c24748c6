// Encodings and tone curves against their definitions.
#include "shading/color.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hm {
namespace {

TEST(Color, SrgbRoundTripAndKnownValues) {
    EXPECT_EQ(srgb_to_linear(0), 0.0f);
    EXPECT_NEAR(srgb_to_linear(1), 1.0f, 1e-6f);
    EXPECT_NEAR(srgb_to_linear(0.5f), 0.21404114f, 1e-6f);
    EXPECT_NEAR(linear_to_srgb(0.18f), 0.46135613f, 1e-6f);
    for (int i = 0; i <= 4096; ++i) {
        float x = float(i) / 4096.0f;
        EXPECT_NEAR(linear_to_srgb(srgb_to_linear(x)), x, 2e-6f);
        EXPECT_NEAR(srgb_to_linear(linear_to_srgb(x)), x, 2e-6f);
    }
    // The two branches meet.
    EXPECT_NEAR(srgb_to_linear(0.04045f), srgb_to_linear(0.04046f), 2e-6f);
    EXPECT_NEAR(linear_to_srgb(0.0031308f), linear_to_srgb(0.0031309f), 4e-6f);
}

// The specification: with a grey x, offset 0.04 above 0.08, compressed from 0.76 towards 1.
float neutral_grey(double x) {
    double offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
    double peak = x - offset;
    return float(peak < 0.76 ? peak : 1 - 0.24 * 0.24 / (peak - 0.52));
}

TEST(Color, NeutralFollowsItsSpecification) {
    for (double x : {0.0, 0.02, 0.08, 0.18, 0.5, 0.79, 0.81, 1.0, 2.0, 10.0, 1000.0})
        EXPECT_NEAR(tone_neutral(vec3(float(x))).y, neutral_grey(x), 2e-6f) << x;
    // A saturated colour below the shoulder only loses the toe; its smallest channel is 0.
    vec3 c = tone_neutral(vec3(0.5f, 0.2f, 0.0f));
    EXPECT_NEAR(c.x, 0.5f, 1e-6f);
    EXPECT_NEAR(c.y, 0.2f, 1e-6f);
    // Pure bright red: peak 10 -> 1 - 0.0576 / 9.48, then desaturated by 0.15.
    double peak = 1 - 0.0576 / (10 + 0.24 - 0.76);
    double g = 1 - 1 / (0.15 * (10 - peak) + 1);
    vec3 red = tone_neutral(vec3(10, 0, 0));
    EXPECT_NEAR(red.x, float(peak), 1e-5f);
    EXPECT_NEAR(red.y, float(peak * g), 1e-5f);
}

TEST(Color, NeutralKeepsBaseColours) {
    // What the curve is for: a base colour lit by white 1.0 (Fresnel 4 % on top) comes out
    // unchanged.
    for (float x = 0.05f; x < 0.75f; x += 0.05f)
        for (float y = 0.05f; y < 0.75f; y += 0.05f) {
            vec3 c = tone_neutral(vec3(x + 0.04f, y + 0.04f, 0.3f + 0.04f));
            EXPECT_NEAR(c.x, x, 1e-6f);
            EXPECT_NEAR(c.y, y, 1e-6f);
            EXPECT_NEAR(c.z, 0.3f, 1e-6f);
        }
}

TEST(Color, CurvesAreMonotoneInGreyAndStayInRange) {
    for (uint curve : {kToneLinear, kToneAces, kToneAgx, kToneNeutral}) {
        float before = -1;
        for (int i = 0; i <= 4000; ++i) {
            float x = i == 0 ? 0.0f : std::exp2(-16.0f + 28.0f * float(i) / 4000.0f);
            vec3 c = tone_map(vec3(x), curve);
            EXPECT_GE(c.y, before - 2e-6f) << curve << " at " << x;
            EXPECT_GE(c.y, 0.0f);
            EXPECT_LE(c.y, 1.0f);
            // The curves' matrices keep grey grey, to the digits they were published with.
            EXPECT_NEAR(c.x, c.y, 1e-3f);
            EXPECT_NEAR(c.z, c.y, 1e-3f);
            before = c.y;
        }
        EXPECT_GT(before, 0.97f) << curve;
        vec3 negative = tone_map(vec3(-1, 5, -100), curve);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_GE(negative[k], 0.0f);
            EXPECT_LE(negative[k], 1.0f);
        }
    }
}

TEST(Color, CurvesAtMiddleGrey) {
    EXPECT_EQ(tone_map(vec3(0.18f), kToneLinear), vec3(0.18f));
    // Hill's fit by hand: rows sum to 1, so v = 0.18.
    double v = 0.18;
    double fit = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    EXPECT_NEAR(tone_map(vec3(0.18f), kToneAces).y, float(fit), 2e-4f);
    // AgX's contrast curve turns around middle grey at 0.5 of the encoded range.
    EXPECT_NEAR(tone_map(vec3(0.18f), kToneAgx).y, std::pow(0.5f, 2.2f), 5e-3f);
}

}  // namespace
}  // namespace hm
