// The environment map: direction mapping, and its sampling against its pdf.
#include "scene/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/light_host.h"
#include "support/scenes.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::LightHost;

constexpr double kPiDouble = std::numbers::pi;

struct Sky {
    const char* name;
    uint width, height;
    std::vector<vec3> texels;
};

std::vector<Sky> skies() {
    test::Random random(81);
    std::vector<Sky> all = {{"1 x 1", 1, 1, {vec3(2, 1, 0)}},
                            {"2 x 1", 2, 1, {vec3(1), vec3(5)}},
                            {"1 x 3", 1, 3, {vec3(1), vec3(0), vec3(4)}}};
    Sky structured{"structured", 16, 8, {}};
    for (uint i = 0; i < 16 * 8; ++i)
        structured.texels.push_back(i % 5 < 2 ? vec3(0) : vec3(random.unit(), random.unit(), 0));
    // A block of zeros wider than the filter, so that some cells are entirely black.
    for (uint y = 2; y < 6; ++y)
        for (uint x = 3; x < 9; ++x)
            structured.texels[y * 16 + x] = vec3(0);
    all.push_back(structured);
    Sky sun{"sun", 64, 32, {}};
    for (uint i = 0; i < 64 * 32; ++i)
        sun.texels.push_back(vec3(random.unit()));
    sun.texels[9 * 64 + 63] = vec3(20000, 18000, 15000);  // at the seam
    all.push_back(sun);
    return all;
}

FlatScene flat_sky(const Sky& sky, float rotation) {
    return test::flatten_quietly(
        Scene{},
        make_environment(test::environment_image(sky.width, sky.height, sky.texels), rotation, 1));
}

vec3 direction_of(double u, double v) {
    double theta = kPiDouble * v, phi = 2 * kPiDouble * (u - 0.5);
    return vec3(float(std::sin(theta) * std::cos(phi)), float(std::cos(theta)),
                float(std::sin(theta) * std::sin(phi)));
}

TEST(Environment, AxesLieWhereTheConventionSays) {
    FlatScene flat = flat_sky({"", 1, 1, {vec3(1)}}, 0);
    LightHost host(flat);
    auto expect = [&](vec3 d, float u, float v) {
        vec2 uv = host.environment_uv(d);
        EXPECT_NEAR(uv.x, u, 1e-6f);
        EXPECT_NEAR(uv.y, v, 1e-6f);
    };
    expect(vec3(1, 0, 0), 0.5f, 0.5f);
    expect(vec3(0, 0, 1), 0.75f, 0.5f);
    expect(vec3(0, 0, -1), 0.25f, 0.5f);
    EXPECT_NEAR(host.environment_uv(vec3(0, 1, 0)).y, 0.0f, 1e-6f);
    EXPECT_NEAR(host.environment_uv(vec3(0, -1, 0)).y, 1.0f, 1e-6f);
    // -x is the seam.
    float seam = host.environment_uv(vec3(-1, 0, 0)).x;
    EXPECT_TRUE(seam < 1e-6f || seam > 1 - 1e-6f);
}

TEST(Environment, RotationAddsToU) {
    FlatScene flat = flat_sky({"", 1, 1, {vec3(1)}}, 90);
    LightHost host(flat);
    EXPECT_NEAR(host.environment_uv(vec3(1, 0, 0)).x, 0.75f, 1e-6f);
}

TEST(Environment, LookupIsTheTexelAtItsCentre) {
    for (const Sky& sky : skies()) {
        FlatScene flat = flat_sky(sky, 0);
        LightHost host(flat);
        for (uint y = 0; y < sky.height; ++y)
            for (uint x = 0; x < sky.width; ++x) {
                vec2 uv((float(x) + 0.5f) / float(sky.width),
                        (float(y) + 0.5f) / float(sky.height));
                vec3 expected = sky.texels[y * sky.width + x];
                EXPECT_LT(length(host.environment_radiance(uv) - expected),
                          1e-5f * length(expected) + 0.02f)
                    << sky.name;
            }
    }
}

TEST(Environment, SamplesMatchTheirDensity) {
    constexpr int kSamples = 300000;
    for (float rotation : {0.0f, 77.0f})
        for (const Sky& sky : skies()) {
            test::Random random(82);
            FlatScene flat = flat_sky(sky, rotation);
            LightHost host(flat);
            // At least twice the texel resolution, indexed by the direction alone.
            const uint columns = sky.width * std::max(16 / sky.width, 2u);
            const uint rows = sky.height * std::max(16 / sky.height, 2u);
            test::Histogram histogram(std::size_t(columns) * rows);
            int mismatches = 0;
            for (int i = 0; i < kSamples; ++i) {
                uint choice = random.bits(), coin = random.bits();
                float u = random.unit(), v = random.unit();
                vec3 radiance;
                float pdf;
                vec3 d = host.sample_environment(choice, coin, u, v, radiance, pdf);
                ASSERT_NEAR(length(d), 1.0f, 1e-5f);
                vec2 uv = host.environment_uv(d);
                histogram.add(std::size_t(std::min(uint(uv.y * float(rows)), rows - 1)) * columns +
                              std::min(uint(uv.x * float(columns)), columns - 1));
                // The pdf that BSDF sampling computes for the same direction, except where rounding
                // moves it into the next cell.
                float other = host.pdf_environment(d, uv);
                mismatches += std::abs(other - pdf) > 1e-3f * pdf ? 1 : 0;
                vec3 seen = host.environment_radiance(uv);
                EXPECT_LT(length(seen - radiance), 1e-3f * length(radiance) + 0.3f);
            }
            EXPECT_LT(mismatches, kSamples / 500) << sky.name;
            std::vector<double> shares(std::size_t(columns) * rows);
            double total = 0;
            constexpr uint kSub = 4;
            for (uint j = 0; j < rows * kSub; ++j)
                for (uint i = 0; i < columns * kSub; ++i) {
                    double u = (i + 0.5) / (columns * kSub), v = (j + 0.5) / (rows * kSub);
                    vec3 d = direction_of(u - double(rotation) / 360, v);
                    double area = 2 * kPiDouble * kPiDouble * std::sin(kPiDouble * v) /
                                  (double(columns * kSub) * double(rows * kSub));
                    double share = area * double(host.pdf_environment(d, vec2(float(u), float(v))));
                    shares[std::size_t(j / kSub) * columns + i / kSub] += share;
                    total += share;
                }
            EXPECT_NEAR(total, 1, 1e-4) << sky.name;
            test::ChiSquare fit = histogram.test(shares);
            EXPECT_GT(fit.p_value, test::single_level())
                << sky.name << ": chi squared " << fit.statistic << " of " << fit.degrees;
        }
}

TEST(Environment, DensityIsNowhereZeroWhereRadianceIsNot) {
    for (const Sky& sky : skies()) {
        FlatScene flat = flat_sky(sky, 0);
        LightHost host(flat);
        int dark = 0;
        for (uint j = 0; j < 256; ++j)
            for (uint i = 0; i < 512; ++i) {
                vec2 uv((float(i) + 0.5f) / 512, (float(j) + 0.5f) / 256);
                bool lit = max_component(host.environment_radiance(uv)) > 0;
                bool found = host.pdf_environment(direction_of(double(uv.x), double(uv.y)), uv) > 0;
                EXPECT_TRUE(found || !lit) << sky.name;
                dark += found ? 0 : 1;
            }
        EXPECT_EQ(dark > 0, sky.width == 16) << sky.name;
    }
}

TEST(Environment, EstimatesTheIrradianceOfThePicture) {
    // The mean of radiance / pdf over the whole sphere is the integral of the looked-up radiance.
    for (const Sky& sky : skies()) {
        test::Random random(83);
        FlatScene flat = flat_sky(sky, 30);
        LightHost host(flat);
        constexpr int kSamples = 100000;
        double mean = 0, squares = 0, exact = 0;
        for (int i = 0; i < kSamples; ++i) {
            uint choice = random.bits(), coin = random.bits();
            float u = random.unit(), v = random.unit();
            vec3 radiance;
            float pdf;
            host.sample_environment(choice, coin, u, v, radiance, pdf);
            double x = double(luminance(radiance)) / double(pdf);
            mean += x / kSamples;
            squares += x * x / kSamples;
        }
        constexpr int kRows = 768, kColumns = 1536;
        for (int j = 0; j < kRows; ++j)
            for (int i = 0; i < kColumns; ++i) {
                vec2 uv((float(i) + 0.5f) / kColumns, (float(j) + 0.5f) / kRows);
                exact += double(luminance(host.environment_radiance(uv))) *
                         std::sin(kPiDouble * (j + 0.5) / kRows) * 2 * kPiDouble * kPiDouble /
                         (double(kRows) * kColumns);
            }
        double error = std::sqrt(std::max(squares - mean * mean, 0.0) / kSamples);
        EXPECT_NEAR(mean, exact, 5 * error + 1e-4 * exact) << sky.name;
        // mean_radiance, used to divide samples between light types, assumes narrow rows.
        if (sky.height < 8) continue;
        EXPECT_NEAR(double(flat.mean_radiance) * 4 * kPiDouble, exact, 0.02 * exact) << sky.name;
    }
}

TEST(Environment, DefaultIsLitFromAbove) {
    EnvironmentMap map = make_environment(default_environment(), 0, 1);
    EXPECT_NEAR(map.mean_radiance, 0.5414f, 0.005f);  // 0.42 + 3.4 / (2 * 14)
    EXPECT_EQ(map.texels.size(), map.alias.size());
    EXPECT_GT(map.texels[map.data.width * 10].x, map.texels[map.data.width * 60].x);
}

// The radiance of a matte white surface: the irradiance by a sum over texels, divided by pi.
double matte_white(const FloatImage& sky, vec3 normal) {
    double sum = 0;
    for (std::uint32_t y = 0; y < sky.height; ++y)
        for (std::uint32_t x = 0; x < sky.width; ++x) {
            const double theta = kPiDouble * (y + 0.5) / sky.height;
            const double phi = 2 * kPiDouble * ((x + 0.5) / sky.width - 0.5);
            const double cosine = std::sin(theta) * std::cos(phi) * double(normal.x) +
                                  std::cos(theta) * double(normal.y) +
                                  std::sin(theta) * std::sin(phi) * double(normal.z);
            const double solid_angle = 2 * kPiDouble * kPiDouble * std::sin(theta) /
                                       (double(sky.width) * double(sky.height));
            sum += std::max(cosine, 0.0) * solid_angle *
                   double(sky.pixels[std::size_t(y) * sky.width + x][0]);
        }
    return sum / kPiDouble;
}

// A white box in the default view: its faces differ clearly, and none is overexposed.
TEST(Environment, DefaultModelsForm) {
    const FloatImage sky = default_environment();
    const double top = matte_white(sky, {0, 1, 0}), front = matte_white(sky, {0, 0, 1});
    const double right = matte_white(sky, {1, 0, 0});
    EXPECT_GT(top, 1.35 * front);
    EXPECT_GT(front, 1.35 * right);
    EXPECT_GT(right, 0.35);
    for (int i = 0; i < 200; ++i) {
        const float z = 1 - (2 * float(i) + 1) / 200, radius = std::sqrt(1 - z * z);
        const float phi = 2.3999632f * float(i);  // a spherical Fibonacci lattice
        EXPECT_LT(matte_white(sky, {radius * std::cos(phi), z, radius * std::sin(phi)}), 1.0);
    }
}

TEST(Environment, DefaultIsGrey) {
    for (const Rgba<float>& pixel : default_environment().pixels) {
        EXPECT_EQ(pixel[0], pixel[1]);
        EXPECT_EQ(pixel[1], pixel[2]);
    }
}

TEST(Environment, BlackMapIsNone) {
    EnvironmentMap map = make_environment(test::environment_image(2, 1, {vec3(0), vec3(0)}), 0, 1);
    EXPECT_EQ(map.data.intensity, 0.0f);
}

}  // namespace
}  // namespace hm
