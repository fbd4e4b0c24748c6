#include "gpu/renderers.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

#include "rhi/test_device.h"
#include "scene/render_params.h"
#include "shading/tables/tables.h"

namespace hm::test {

using rhi::test::expect_ok;
using rhi::test::value_of;

namespace {

std::unique_ptr<GpuContext> make_context(Diagnostics& diagnostics) {
    const std::shared_ptr<rhi::Instance> instance = rhi::test::make_instance();
    const rhi::PhysicalDevice physical = rhi::test::any_device(*instance);
    std::printf("on %s, %s\n", physical.name.c_str(), physical.driver.c_str());
    return value_of(
        GpuContext::create(value_of(rhi::Device::create(instance, physical)), "", diagnostics));
}

}  // namespace

GpuContext& gpu_context() {
    static Diagnostics diagnostics;
    static const std::unique_ptr<GpuContext> context = make_context(diagnostics);
    return *context;
}

void expect_no_messages() {
    for (const rhi::Message& message : gpu_context().device().instance().messages().take())
        ADD_FAILURE() << message.line();
}

RenderJob make_job(const FlatScene& scene, const CameraData& camera) {
    RenderJob job;
    job.camera = camera;
    job.params = make_params(scene, kPictureSize, kPictureSize,
                             {.seed = 5, .bounces = 6, .filter = PixelFilter::gaussian});
    job.filter_table = make_filter_table(PixelFilter::gaussian);
    return job;
}

void draw_into(Renderer& renderer, const RenderJob& job, Film& film) {
    RenderCounters counters;
    expect_ok(renderer.begin(job, film));
    expect_ok(renderer.render(0, kPictureSamples, counters, std::atomic<bool>(false)));
    expect_ok(renderer.sync());
    EXPECT_EQ(counters.samples, film.sums.size() * kPictureSamples);
    EXPECT_GE(counters.rays, counters.samples);
    EXPECT_EQ(counters.non_finite, 0u);
}

Film draw(Renderer& renderer, const RenderJob& job, PixelRect crop) {
    Film film(crop);
    draw_into(renderer, job, film);
    return film;
}

Film draw(Renderer& renderer, const RenderJob& job) {
    return draw(renderer, job, {0, 0, job.params.width, job.params.height});
}

Duel::Duel(const FlatScene& scene)
    : cpu_(scene, 0), gpu_(value_of(VulkanRenderer::create(gpu_context(), scene))) {}

std::size_t Duel::expect_parity(const RenderJob& job, const std::string& what) {
    const std::size_t off =
        expect_same_picture(means_of(draw(*gpu_, job)), means_of(draw(cpu_, job)), what);
    expect_no_messages();
    return off;
}

}  // namespace hm::test
