// Pipelines and launches that render the same samples must agree in every bit and in the number of
// rays.
#include <gtest/gtest.h>

#include <cstring>

#include "gpu/path_tracer.h"
#include "gpu/renderers.h"
#include "rhi/test_device.h"
#include "rhi/upload.h"

namespace hm::test {

namespace {

using rhi::test::expect_ok;
using rhi::test::value_of;

constexpr std::uint32_t kSamples = 5;

struct Drawn {
    std::vector<vec4> sums = std::vector<vec4>(kPictureSize * kPictureSize);
    std::uint64_t rays = 0;
    std::uint64_t non_finite = 0;
};

// The feature scene under the default settings.
class PathTracingVariants : public ::testing::Test {
  protected:
    PathTracingVariants() {
        expect_ok(gpu_->set_frame(job_));
        sums_ = value_of(rhi::Image::create(device_, {"sums", rhi::Format::rgba32f, kPictureSize,
                                                      kPictureSize, 1, rhi::ImageUse::storage}));
        removed_ = value_of(rhi::Image::create(
            device_, {"removed", rhi::Format::r32f, 1, 1, 1, rhi::ImageUse::storage}));
        counters_ = value_of(
            rhi::Buffer::create(device_, {"counters", kCounterRows * sizeof(TraceCounters)}));
    }
    void TearDown() override { expect_no_messages(); }

    void set_frame(const RenderJob& job) { expect_ok(gpu_->set_frame(job)); }
    const RenderJob& job() const { return job_; }

    Drawn draw(const PathTracingVariant& variant, Launches launches) {
        const PathTracingPass* pass = value_of(gpu_context().path_tracing(variant));
        TraceRange range{};
        range.sample_end = kSamples;
        expect_ok(rhi::run_once(device_, "draw", [&](rhi::Commands& commands) -> Result<void> {
            for (const rhi::Image* image : {&sums_, &removed_}) {
                commands.transition(*image, rhi::ImageLayout::undefined, rhi::ImageLayout::general);
                commands.clear(*image, rhi::ImageLayout::general, 0);
            }
            commands.fill(counters_, 0);
            commands.full_barrier();
            pass->record(commands, *gpu_, {sums_, removed_, counters_}, range, kPictureSize,
                         launches);
            return {};
        }));
        return read();
    }

  private:
    Drawn read() {
        Drawn drawn;
        expect_ok(rhi::read_back(device_, sums_, rhi::ImageLayout::general,
                                 std::as_writable_bytes(std::span(drawn.sums))));
        std::vector<TraceCounters> counters(kCounterRows);
        expect_ok(rhi::read_back(device_, counters_, std::as_writable_bytes(std::span(counters))));
        for (const TraceCounters& row : counters) {
            drawn.rays += row.rays;
            drawn.non_finite += row.non_finite;
        }
        return drawn;
    }

    TestScene scene_;
    RenderJob job_ = make_job(scene_.flat, scene_.camera);
    rhi::Device& device_ = gpu_context().device();
    std::unique_ptr<GpuScene> gpu_ =
        value_of(GpuScene::create(device_, gpu_context().layouts(), scene_.flat));
    rhi::Image sums_, removed_;
    rhi::Buffer counters_;
};

void expect_same(const Drawn& a, const Drawn& b) {
    EXPECT_EQ(std::memcmp(a.sums.data(), b.sums.data(), a.sums.size() * sizeof(vec4)), 0);
    EXPECT_EQ(a.rays, b.rays);
    EXPECT_EQ(a.non_finite, b.non_finite);
}

TEST_F(PathTracingVariants, LaunchesOfOneSampleAddUpToALoop) {
    const PathTracingVariant variant = {.settings = settings_of(job().params)};
    const Drawn loop = draw(variant, Launches::loop);
    EXPECT_GT(loop.rays, 2 * kSamples * loop.sums.size());
    EXPECT_EQ(loop.sums[0].w, float(kSamples));
    expect_same(loop, draw(variant, Launches::one_per_sample));
}

// A pipeline with specialization constants renders the same bits as one that reads the settings
// from the uniform block, and does not read them from there.
TEST_F(PathTracingVariants, SettingsAreSpecializationConstants) {
    const PathTracingVariant variant = {.settings = settings_of(job().params)};
    const Drawn constant = draw(variant, Launches::loop);
    expect_same(constant, draw({}, Launches::loop));
    RenderJob other = job();
    other.params.energy_compensation = 0;
    other.params.background = kBackgroundTransparent;
    set_frame(other);
    expect_same(constant, draw(variant, Launches::loop));
    EXPECT_NE(constant.sums, draw({}, Launches::loop).sums);
}

// Every clamp but none has the same pipeline, so that a new number compiles nothing.
TEST(PathTracingSettings, ClampsShareOnePipeline) {
    RenderParams params{};
    const auto without = settings_of(params);
    params.max_radiance = 2.0f;
    const auto two = settings_of(params);
    params.max_radiance = 10.0f;
    EXPECT_EQ(settings_of(params), two);
    EXPECT_NE(two, without);
}

}  // namespace

}  // namespace hm::test
