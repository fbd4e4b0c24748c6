// Bit-identical results for any thread count, batching and crop; all samplers have the same mean.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "support/pictures.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Shot;
using test::Studio;

SceneBuilder room() {
    SceneBuilder b;
    Material shiny;
    shiny.base_color = vec4(0.9f, 0.7f, 0.4f, 1);
    shiny.roughness = 0.3f;
    Material glassy = test::lambertian(vec3(0.3f, 0.3f, 0.8f));
    glassy.alpha_mode = kAlphaBlend;
    glassy.base_color.w = 0.5f;
    b.place(test::add_cube(b, true, b.material(test::lambertian(vec3(0.7f)))));
    b.place(b.sphere(24, b.material(shiny)),
            glm::scale(glm::translate(glm::mat4(1), vec3(0.3f, -0.6f, 0)), vec3(0.4f)));
    b.place(b.sphere(24, b.material(glassy)),
            glm::scale(glm::translate(glm::mat4(1), vec3(-0.4f, -0.5f, 0.2f)), vec3(0.4f)));
    b.place(b.quad(vec3(-0.4f, 0.98f, -0.4f), vec3(0.8f, 0, 0), vec3(0, 0, 0.8f),
                   b.material(test::emitter(vec3(8)))));
    Light lamp;
    lamp.intensity = 0.3f;
    b.light(lamp, glm::translate(glm::mat4(1), vec3(0.7f, 0.5f, 0.7f)));
    return b;
}

CameraData room_camera() {
    CameraData c = test::flat_camera(vec3(0), vec3(0.1f, 0.1f, 1), 0.9f);
    c.kind = kCameraPerspective;
    c.origin = vec3(0, 0, 0.95f);
    return c;
}

bool same_bits(const std::vector<PixelSum>& a, const std::vector<PixelSum>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

TEST(Repeatability, ThreadsBatchesAndCropsChangeNoBit) {
    for (uint sampler : {kSamplerIndependent, kSamplerSobolBlueNoise, kSamplerSobolOwen}) {
        Shot shot{.width = 40, .height = 24, .samples = 6, .bounces = 4, .sampler = sampler};
        const PixelRect all{0, 0, 40, 24};
        SceneBuilder b = room();
        Studio one(b.scene, {}, {}, 1);
        const std::vector<PixelSum> expected = one.render_sums(room_camera(), shot, all);
        for (unsigned threads : {2u, 3u}) {
            Studio more(b.scene, {}, {}, threads);
            EXPECT_TRUE(same_bits(more.render_sums(room_camera(), shot, all), expected)) << threads;
        }
        const PixelRect crop{7, 3, 29, 20};
        const std::vector<PixelSum> part = one.render_sums(room_camera(), shot, crop);
        for (uint y = crop.y0; y < crop.y1; ++y)
            EXPECT_EQ(std::memcmp(&part[(y - crop.y0) * crop.width()], &expected[y * 40 + crop.x0],
                                  crop.width() * sizeof(PixelSum)),
                      0);
    }
}

TEST(Repeatability, SamplesAreTheSameInWhateverBatch) {
    Shot shot{.width = 16, .height = 16, .bounces = 4, .sampler = kSamplerSobolOwen};
    SceneBuilder b = room();
    Studio studio(b.scene);
    const PixelRect all{0, 0, 16, 16};
    shot.samples = 1;
    std::vector<PixelSum> one_by_one(256, PixelSum{});
    for (uint i = 0; i < 8; ++i) {
        shot.first_sample = i;
        std::vector<PixelSum> s = studio.render_sums(room_camera(), shot, all);
        for (std::size_t k = 0; k < 256; ++k) {
            one_by_one[k].radiance += s[k].radiance;
            one_by_one[k].alpha += s[k].alpha;
            one_by_one[k].weight += s[k].weight;
            one_by_one[k].removed += s[k].removed;
        }
    }
    shot.first_sample = 0;
    shot.samples = 8;
    EXPECT_TRUE(same_bits(studio.render_sums(room_camera(), shot, all), one_by_one));
    shot.seed = 2;
    EXPECT_FALSE(same_bits(studio.render_sums(room_camera(), shot, all), one_by_one));
}

TEST(Repeatability, SamplersShareTheirMean) {
    SceneBuilder b = room();
    Studio studio(b.scene);
    Shot shot{.width = 12, .height = 12, .samples = 64, .bounces = 6};
    shot.sampler = kSamplerIndependent;
    const auto independent = test::replicate(studio, room_camera(), shot, 16, 100);
    shot.sampler = kSamplerSobolOwen;
    const auto owen = test::replicate(studio, room_camera(), shot, 16, 200);
    test::expect_same_pictures(independent, owen, "independent and Owen");
    // Rotated Sobol points of different seeds share their tile, so only image means are compared.
    shot.sampler = kSamplerSobolBlueNoise;
    const auto blue = test::replicate(studio, room_camera(), shot, 16, 300);
    std::vector<vec3> a, c;
    for (std::size_t i = 0; i < 16; ++i) {
        a.push_back(independent[i].mean());
        c.push_back(blue[i].mean());
    }
    const test::Estimate one = test::estimate(a), two = test::estimate(c);
    EXPECT_NEAR(one.mean.x, two.mean.x, 6 * one.error.x);
    EXPECT_LT(two.error.x, one.error.x);
}

TEST(Repeatability, ClampTakesAwayWhatItReports) {
    SceneBuilder b = room();
    Studio studio(b.scene);
    Shot shot{.width = 16, .height = 16, .samples = 64, .bounces = 4};
    const PixelRect all{0, 0, 16, 16};
    const std::vector<PixelSum> free = studio.render_sums(room_camera(), shot, all);
    shot.clamp = 0.3f;
    const std::vector<PixelSum> clamped = studio.render_sums(room_camera(), shot, all);
    double removed = 0, difference = 0;
    for (std::size_t i = 0; i < free.size(); ++i) {
        removed += double(clamped[i].removed);
        vec3 d = free[i].radiance - clamped[i].radiance;
        difference += double(0.2126f * d.x + 0.7152f * d.y + 0.0722f * d.z);
        EXPECT_EQ(free[i].removed, 0.0f);
    }
    EXPECT_GT(removed, 0.0);
    EXPECT_NEAR(removed, difference, 1e-3 * removed);
}

}  // namespace
}  // namespace hm
