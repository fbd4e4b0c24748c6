// The whole path tracer as GLSL and as C++, over the same tables and the same brute-force hooks:
// with the same seed both draw the same picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "gpu/compute.h"
#include "gpu/path_tracer.h"
#include "shaders/path_comp.h"

namespace hm::test {

namespace {

constexpr std::uint32_t kSize = 32;
constexpr std::uint32_t kSamples = 16;
constexpr std::uint32_t kGroupSize = 64;
constexpr std::uint32_t kBuffers = 26;  // the picture, the run's numbers, and the tables

using Picture = std::vector<vec4>;

Picture draw_on_gpu(PathTracer& tracer, const ComputeShader& shader) {
    Picture picture(kSize * kSize);
    std::vector<std::uint32_t> run = {kSamples};
    PathTracer::Settings settings;
    std::vector<std::span<std::byte>> buffers = {bytes_of(picture), bytes_of(run)};
    for (const std::span<std::byte> table : tracer.buffers(settings))
        buffers.push_back(table);
    shader.run(buffers, kSize * kSize / kGroupSize);
    return picture;
}

Picture draw_on_cpu(PathTracer& tracer) {
    Picture picture;
    for (std::uint32_t pixel = 0; pixel < kSize * kSize; ++pixel) {
        vec4 sum(0);
        for (std::uint32_t i = 0; i < kSamples; ++i) {
            PathSample s;
            tracer.trace_sample(pixel % kSize, pixel / kSize, i, s);
            sum += vec4(s.radiance, s.alpha);
        }
        picture.push_back(sum / float(kSamples));
    }
    return picture;
}

// The mean of one channel within 1e-3 of its value or four standard errors of the paired
// differences, and 99 % of its pixels within 1e-2.
void expect_same(const Picture& gpu, const Picture& cpu, glm::length_t channel) {
    const auto count = static_cast<double>(cpu.size());
    double mean = 0;
    double difference = 0;
    double squares = 0;
    std::size_t far = 0;
    for (std::size_t i = 0; i < cpu.size(); ++i) {
        const auto a = static_cast<double>(gpu[i][channel]);
        const auto b = static_cast<double>(cpu[i][channel]);
        mean += b / count;
        difference += (a - b) / count;
        squares += (a - b) * (a - b) / count;
        far += !(std::abs(a - b) <= 1e-2 * std::max(std::abs(a), std::abs(b))) ? 1u : 0u;
    }
    const double error = std::sqrt(std::max(squares - difference * difference, 0.0) / count);
    std::printf("channel %d: mean %.5f, difference %.1e, %zu of %zu pixels off\n", int(channel),
                mean, difference, far, cpu.size());
    EXPECT_GT(mean, 0.0) << "the picture is black";
    EXPECT_LE(std::abs(difference), std::max(1e-3 * mean, 4 * error));
    EXPECT_LE(far, cpu.size() / 100);
}

struct Variant {
    const char* name;
    void (*configure)(PathTracer&);
};

const Variant kVariants[] = {
    {"defaults", [](PathTracer&) {}},
    {"blue noise, BSDF sampling, transparent background, lens",
     [](PathTracer& tracer) {
         tracer.params.sampler_kind = kSamplerSobolBlueNoise;
         tracer.params.strategy = kStrategyBsdf;
         tracer.params.background = kBackgroundTransparent;
         tracer.params.energy_compensation = 0;
         tracer.camera.lens_radius = 0.1f;
         tracer.camera.focus_distance = 5;
     }},
    {"independent, light sampling, unlimited bounces, clamp, orthographic",
     [](PathTracer& tracer) {
         tracer.params.sampler_kind = kSamplerIndependent;
         tracer.params.strategy = kStrategyLight;
         tracer.params.max_bounces = 0;
         tracer.params.max_radiance = 2;
         tracer.params.diffuse_kind = kDiffuseBurley;
         tracer.params.background = kBackgroundColor;
         tracer.params.background_color = {0.1f, 0.2f, 0.3f};
         tracer.camera.kind = kCameraOrthographic;
         tracer.camera.half_width = tracer.camera.half_height = 2.2f;
     }},
};

void compare(const TestScene& scene, const ComputeShader& shader, const Variant& variant) {
    PathTracer tracer(scene.flat);
    tracer.camera = scene.camera;
    tracer.params = scene.params();
    tracer.params.width = tracer.params.height = kSize;
    variant.configure(tracer);
    set_light_ranges(scene.flat, tracer.params);
    std::printf("%s\n", variant.name);
    const Picture gpu = draw_on_gpu(tracer, shader);
    const Picture cpu = draw_on_cpu(tracer);
    for (glm::length_t channel = 0; channel < 4; ++channel) {
        SCOPED_TRACE(channel);
        expect_same(gpu, cpu, channel);
    }
}

// One test for all: software devices need a minute to compile the shader.
TEST(PathParity, SamePictureInBothLanguages) {
    const TestScene scene;
    const ComputeDevice device;
    std::printf("on %s\n", device.name().c_str());
    const ComputeShader shader(device, shaders::path_comp(), kBuffers);
    for (const Variant& variant : kVariants) {
        SCOPED_TRACE(variant.name);
        compare(scene, shader, variant);
    }
}

}  // namespace

}  // namespace hm::test
