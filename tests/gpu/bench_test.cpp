// The ray counts of gpu/bench on a scene whose rays are known. Times are not asserted.
#include "gpu/bench.h"

#include <gtest/gtest.h>

#include "gpu/path_tracer.h"
#include "gpu/renderers.h"

namespace hm::test {

namespace {

TEST(TraceBench, CountsTheRaysOfAPicture) {
    const TestScene scene;
    RenderJob job = make_job(scene.flat, scene.camera);
    auto gpu = GpuScene::create(gpu_context().device(), gpu_context().layouts(), scene.flat);
    ASSERT_TRUE(gpu) << gpu.error().line();
    const auto rates = measure_tracing(gpu_context(), **gpu, job, false, 1);
    ASSERT_TRUE(rates) << rates.error().line();

    CpuRenderer cpu(scene.flat, 0);
    Film film({0, 0, kPictureSize, kPictureSize});
    RenderCounters counters;
    ASSERT_TRUE(cpu.begin(job, film));
    ASSERT_TRUE(cpu.render(0, 1, counters, std::atomic<bool>(false)));
    EXPECT_NEAR(double(rates->rays()), double(counters.rays), 1e-3 * double(counters.rays));
    EXPECT_GT(rates->shadow_rays, 0u);
    EXPECT_GT(rates->closest_rays, rates->shadow_rays);
    EXPECT_GE(rates->several, 2u);
    EXPECT_FALSE(rates->ways.empty());
    for (const auto& [way, ms] : rates->ways)
        EXPECT_GT(ms, 0.0) << way;
    expect_no_messages();
}

}  // namespace

}  // namespace hm::test
