// The variance layer predicts the variance between images with different seeds.
#include <gtest/gtest.h>

#include <cmath>

#include "film/variance.h"
#include "support/pictures.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Shot;
using test::Studio;

// A floor under a small lamp and a sky: both contribute noise.
SceneBuilder lit_floor() {
    SceneBuilder b;
    b.place(b.quad(vec3(-2, 0, -2), vec3(0, 0, 4), vec3(4, 0, 0),
                   b.material(test::lambertian(vec3(0.7f)))));
    b.place(b.quad(vec3(-0.3f, 1, -0.3f), vec3(0.6f, 0, 0), vec3(0, 0, 0.6f),
                   b.material(test::emitter(vec3(9)))));
    return b;
}

// Over many seeds, compares the mean of the estimated variances of a pixel's mean with the actual
// sample variance of the means. For n independent, roughly normally distributed means, the sample
// variance has a relative error of sqrt(2 / n); the average of the estimates, each with at least 3
// degrees of freedom, has one of sqrt(2 / 3 / n). With n = 600 seeds and 16 independent pixels, the
// ratio of the sums has a standard error of sqrt((2 + 2 / 3) / 9600) = 1.7 %; the tolerance is five
// of those, plus one percent for distributions that are not normal.
TEST(AovVariance, IsThatOfTheMean) {
    Studio studio(lit_floor().scene, test::constant_environment(vec3(0.5f)));
    const CameraData camera = test::flat_camera(vec3(0.4f, 0, 0), vec3(0.2f, 1, 0.3f), 0.5f);
    constexpr int kSeeds = 600;
    for (const uint sampler : {kSamplerIndependent, kSamplerSobolBlueNoise, kSamplerSobolOwen})
        for (const uint samples : {16u, 18u}) {
            SCOPED_TRACE(testing::Message() << "sampler " << sampler << ", " << samples);
            Shot shot{
                .width = 4, .height = 4, .samples = samples, .bounces = 2, .sampler = sampler};
            std::vector<double> sums(48), squares(48), estimated(48);
            for (int seed = 0; seed < kSeeds; ++seed) {
                shot.seed = 1000 + uint(seed);
                const Film film = studio.render_film(camera, shot, {Aov::variance});
                const std::vector<float> variances = variance_of_means(film);
                for (std::size_t i = 0; i < 48; ++i) {
                    const double mean = double(film.sums[i / 3].radiance[i % 3]) / samples;
                    sums[i] += mean;
                    squares[i] += mean * mean;
                    estimated[i] += double(variances[i]) / kSeeds;
                }
            }
            double actual = 0, told = 0;
            for (std::size_t i = 0; i < 48; ++i) {
                const double mean = sums[i] / kSeeds;
                actual += (squares[i] / kSeeds - mean * mean) * kSeeds / (kSeeds - 1);
                told += estimated[i];
            }
            EXPECT_NEAR(told / actual, 1.0, 5 * 0.017 + 0.01);
        }
}

TEST(AovVariance, TooFewSamplesTellNothing) {
    Studio studio(lit_floor().scene, test::constant_environment(vec3(0.5f)));
    const CameraData camera = test::flat_camera(vec3(0.4f, 0, 0), vec3(0.2f, 1, 0.3f), 0.5f);
    for (const uint sampler : {kSamplerIndependent, kSamplerSobolOwen}) {
        const uint least = sampler == kSamplerIndependent ? 2u : kReplicates;
        for (const uint samples : {least - 1, least}) {
            const Shot shot{.width = 2, .height = 2, .samples = samples, .sampler = sampler};
            const Film film = studio.render_film(camera, shot, {Aov::variance});
            EXPECT_EQ(std::isfinite(variance_of_means(film)[0]), samples == least);
            EXPECT_EQ(estimated_error(film).has_value(), samples == least);
        }
    }
}

TEST(AovVariance, FilmsWithoutItTellNothing) {
    EXPECT_FALSE(estimated_error(Film({0, 0, 2, 2})));
}

}  // namespace
}  // namespace hm
