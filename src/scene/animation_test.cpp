// Animation samplers against closed forms.
#include "scene/animation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace hm {
namespace {

constexpr double kPi = std::numbers::pi;

float scalar(const AnimationSampler& sampler, double seconds) {
    std::array<float, 1> out{};
    evaluate(sampler, seconds, out);
    return out[0];
}

vec4 turn_about_z(double angle) {
    return vec4(0, 0, float(std::sin(angle / 2)), float(std::cos(angle / 2)));
}

AnimationSampler rotations(Interpolation interpolation, const std::vector<vec4>& keys) {
    AnimationSampler s{interpolation, {}, {}};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        s.times.push_back(float(i));
        s.values.insert(s.values.end(), &keys[i][0], &keys[i][0] + 4);
    }
    return s;
}

void expect_near(vec4 a, vec4 b) {
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(double(a[i]), double(b[i]), 1e-6) << i;
}

TEST(Sampler, StepHoldsTheLastKey) {
    const AnimationSampler s{Interpolation::step, {1, 2, 4}, {10, 20, 40}};
    EXPECT_EQ(scalar(s, 1), 10);
    EXPECT_EQ(scalar(s, 1.999), 10);
    EXPECT_EQ(scalar(s, 2), 20);
    EXPECT_EQ(scalar(s, 3.999), 20);
    EXPECT_EQ(scalar(s, 4), 40);
}

TEST(Sampler, LinearAndClamped) {
    const AnimationSampler s{Interpolation::linear, {1, 2, 4}, {10, 20, 40}};
    EXPECT_EQ(scalar(s, -5), 10);
    EXPECT_EQ(scalar(s, 0), 10);
    EXPECT_EQ(scalar(s, 1.25), 12.5f);
    EXPECT_EQ(scalar(s, 2), 20);
    EXPECT_EQ(scalar(s, 3), 30);
    EXPECT_EQ(scalar(s, 4), 40);
    EXPECT_EQ(scalar(s, 1e30), 40);
}

TEST(Sampler, OneKeyIsAConstant) {
    const AnimationSampler s{Interpolation::linear, {3}, {7}};
    for (const double t : {0.0, 3.0, 9.0})
        EXPECT_EQ(scalar(s, t), 7);
}

TEST(Sampler, CubicSplineIsHermites) {
    // Two values per key; keys are 2 s apart, so tangents are scaled by 2.
    const double a = 1, b = 5, out_tangent = 3, in_tangent = -4;
    const AnimationSampler s{Interpolation::cubic_spline,
                             {1, 3},
                             {99, 99, float(a), 0, float(out_tangent), 0,  //
                              float(in_tangent), 0, float(b), 0, 99, 99}};
    ASSERT_EQ(s.width(), 2u);
    for (const double t : {0.25, 0.5, 0.9}) {
        std::array<float, 2> got{};
        evaluate(s, 1 + 2 * t, got);
        // Bernstein (Bezier) form of the same curve: tangents give the inner control points.
        const double c1 = a + 2 * out_tangent / 3, c2 = b - 2 * in_tangent / 3, u = 1 - t;
        const double expected =
            u * u * u * a + 3 * u * u * t * c1 + 3 * u * t * t * c2 + t * t * t * b;
        EXPECT_NEAR(double(got[0]), expected, 1e-6 * std::abs(expected)) << t;
        EXPECT_EQ(got[1], 0.0f);
    }
    std::array<float, 2> got{};
    evaluate(s, 0, got);
    EXPECT_EQ(got[0], float(a));
    evaluate(s, 3, got);
    EXPECT_EQ(got[0], float(b));
}

TEST(Rotations, ConstantSpeedAlongTheArc) {
    const AnimationSampler s =
        rotations(Interpolation::linear, {turn_about_z(0), turn_about_z(kPi * 2 / 3)});
    expect_near(evaluate_rotation(s, 0.5), turn_about_z(kPi / 3));
    expect_near(evaluate_rotation(s, 0.25), turn_about_z(kPi / 6));
}

TEST(Rotations, TheShorterWay) {
    // The negated quaternion of the same rotation: 60 degrees, not 300.
    const AnimationSampler s =
        rotations(Interpolation::linear, {turn_about_z(0), -turn_about_z(kPi / 3)});
    expect_near(evaluate_rotation(s, 0.5), turn_about_z(kPi / 6));
}

TEST(Rotations, TinyTurnsAndOtherLengths) {
    const AnimationSampler same =
        rotations(Interpolation::linear, {turn_about_z(1), turn_about_z(1)});
    expect_near(evaluate_rotation(same, 0.5), turn_about_z(1));
    const AnimationSampler longer =
        rotations(Interpolation::linear, {3.0f * turn_about_z(0), 0.5f * turn_about_z(1)});
    expect_near(evaluate_rotation(longer, 0.5), turn_about_z(0.5));
    const AnimationSampler step =
        rotations(Interpolation::step, {2.0f * turn_about_z(1), turn_about_z(0)});
    expect_near(evaluate_rotation(step, 0.9), turn_about_z(1));
}

}  // namespace
}  // namespace hm
