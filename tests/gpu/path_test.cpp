// The whole path tracer as GLSL and as C++, over the same tables and the same brute-force hooks:
// with the same seed both draw the same picture.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <vector>

#include "gpu/compute.h"
#include "gpu/path_tracer.h"
#include "gpu/same_picture.h"
#include "scene/render_params.h"
#include "shaders/path_comp.h"

namespace hm::test {

namespace {

constexpr std::uint32_t kSize = 32;
constexpr std::uint32_t kSamples = 16;
constexpr std::uint32_t kGroupSize = 64;
// The picture, the number of samples, and the buffers of PathTracer.
constexpr std::uint32_t kBuffers = 2 + PathTracer::kBufferCount;

Pixels draw_on_gpu(PathTracer& tracer, const ComputeShader& shader) {
    Pixels picture(kSize * kSize);
    std::vector<std::uint32_t> run = {kSamples};
    PathTracer::Settings settings;
    std::vector<std::span<std::byte>> buffers = {bytes_of(picture), bytes_of(run)};
    for (const std::span<std::byte> table : tracer.buffers(settings))
        buffers.push_back(table);
    shader.run(buffers, kSize * kSize / kGroupSize);
    return picture;
}

Pixels draw_on_cpu(PathTracer& tracer) {
    Pixels picture;
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
    const Pixels gpu = draw_on_gpu(tracer, shader);
    const Pixels cpu = draw_on_cpu(tracer);
    expect_same_picture(gpu, cpu, variant.name);
}

// One test for all settings: software devices need a minute to compile the shader.
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
