// Renders a small picture with the real renderers, once for each Vulkan call that may fail during
// upload, acceleration structure builds, rendering and readback. The error must name the call, and
// with --device auto the CPU must complete the picture with the samples already in the film.
#include <gtest/gtest.h>

#include <cstring>

#include "gpu/path_tracer.h"
#include "gpu/renderers.h"
#include "session/devices.h"
#include "trouble/sweep.h"

namespace hm::test {
namespace {

constexpr std::uint32_t kSide = 8, kFirst = 2, kAll = 5;

// The device shared by all tests, so that pipelines are compiled once.
class SharedGpu final : public RenderDevice {
  public:
    std::string name() const override { return "Vulkan"; }
    Result<std::unique_ptr<Renderer>> load(const FlatScene& scene) override {
        HM_TRY_ASSIGN(std::unique_ptr<Renderer> renderer,
                      VulkanRenderer::create(gpu_context(), scene));
        return renderer;
    }
};

bool same_bits(const Film& a, const Film& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x.size() == y.size() &&
               (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0);
    };
    bool all = same(a.sums, b.sums) && a.planes.size() == b.planes.size();
    for (std::size_t p = 0; all && p < a.planes.size(); ++p)
        all = same(a.planes[p].values, b.planes[p].values);
    for (std::size_t i = 0; all && i < a.ids.size(); ++i)
        all = same(a.ids[i], b.ids[i]);
    return all;
}

class Drawing : public testing::Test {
  protected:
    static void SetUpTestSuite() { enable_trouble_layer(); }

    Drawing() {
        job_.params.width = job_.params.height = kSide;
        job_.params.max_radiance = 2;  // so that all sums are at work
    }
    void TearDown() override { expect_no_messages(); }

    Film empty_film() const { return Film({0, 0, kSide, kSide}, selection_); }

    // In two ranges, until the renderer fails.
    Result<void> draw(Renderer& renderer, Film& film, RenderCounters& counters) const {
        const std::atomic<bool> cancel{false};
        HM_TRY(renderer.begin(job_, film));
        HM_TRY(renderer.render(0, kFirst, counters, cancel));
        HM_TRY(renderer.sync());
        HM_TRY(renderer.render(kFirst, kAll, counters, cancel));
        return renderer.sync();
    }

    // The picture of a GPU that is replaced after `gpu_samples` (0, kFirst or kAll).
    Film expected(std::uint32_t gpu_samples) {
        Film film = empty_film();
        RenderCounters counters;
        const std::atomic<bool> cancel{false};
        const auto add = [&](Renderer& renderer, std::uint32_t begin, std::uint32_t end) {
            if (begin == end) return;
            EXPECT_TRUE(renderer.begin(job_, film));
            EXPECT_TRUE(renderer.render(begin, end, counters, cancel));
            EXPECT_TRUE(renderer.sync());
        };
        SharedGpu gpu;
        const auto renderer = gpu.load(scene_.flat);
        EXPECT_TRUE(renderer);
        CpuRenderer cpu(scene_.flat, 1);
        add(**renderer, 0, gpu_samples);
        add(cpu, gpu_samples, kAll);
        return film;
    }

    void sweep_with_fallback(VkResult result);
    void sweep_without_fallback(VkResult result);

    TestScene scene_;
    RenderJob job_ = make_job(scene_.flat, scene_.camera);
    AovSelection selection_;
};

void Drawing::sweep_with_fallback(VkResult result) {
    const Film none = expected(0), first = expected(kFirst), all = expected(kAll);
    std::vector<std::string> lines;
    Film film = empty_film();
    RenderCounters counters;
    std::string drew;
    const auto attempt = [&]() -> std::optional<Error> {
        lines.clear();
        film = empty_film();
        counters.samples = counters.rays = counters.non_finite = 0;
        const auto device = choose_device(
            {}, 1, [](auto) { return std::make_unique<SharedGpu>(); },
            [&](std::string_view line) { lines.emplace_back(line); });
        auto renderer = (*device)->load(scene_.flat);
        if (!renderer) return renderer.error();
        if (Result<void> drawn = draw(**renderer, film, counters); !drawn) return drawn.error();
        drew = (*renderer)->report().device;
        return std::nullopt;
    };
    sweep(result, attempt, [&](const std::string&, const std::optional<Error>& error) {
        ASSERT_FALSE(error) << error->line();
        const bool both = drew.find(", then CPU") != std::string::npos;
        EXPECT_TRUE(same_bits(film, drew == "CPU" ? none : both ? first : all)) << drew;
        EXPECT_EQ(counters.samples, film.sums.size() * kAll);
        ASSERT_EQ(lines.size(), drew == "CPU" || both ? 2u : 1u);
        if (lines.size() == 2) {
            EXPECT_TRUE(lines[1].starts_with("continuing with the CPU: Vulkan: ")) << lines[1];
            EXPECT_NE(lines[1].find(" returned VK_ERROR_"), std::string::npos) << lines[1];
        }
    });
}

// The film has exactly the synchronised samples.
void Drawing::sweep_without_fallback(VkResult result) {
    const Film none = empty_film(), all = expected(kAll);
    Film first = empty_film();
    {
        SharedGpu gpu;
        const auto renderer = gpu.load(scene_.flat);
        RenderCounters counters;
        ASSERT_TRUE((*renderer)->begin(job_, first));
        ASSERT_TRUE((*renderer)->render(0, kFirst, counters, std::atomic<bool>(false)));
        ASSERT_TRUE((*renderer)->sync());
    }
    Film film = empty_film();
    const auto attempt = [&]() -> std::optional<Error> {
        film = empty_film();
        SharedGpu gpu;
        auto renderer = gpu.load(scene_.flat);
        if (!renderer) return renderer.error();
        RenderCounters counters;
        if (Result<void> drawn = draw(**renderer, film, counters); !drawn) return drawn.error();
        return std::nullopt;
    };
    sweep(result, attempt, [&](const std::string& function, const std::optional<Error>& error) {
        if (!error) {
            EXPECT_TRUE(same_bits(film, all)) << function;
            return;
        }
        expect_named(*error, result);
        EXPECT_EQ(error->kind, ErrorKind::device_failed);
        EXPECT_TRUE(same_bits(film, none) || same_bits(film, first)) << error->line();
    });
}

TEST_F(Drawing, OutOfMemoryHasAName) {
    sweep_without_fallback(VK_ERROR_OUT_OF_DEVICE_MEMORY);
}

TEST_F(Drawing, ALostDeviceHasAName) {
    sweep_without_fallback(VK_ERROR_DEVICE_LOST);
}

TEST_F(Drawing, OutOfMemoryLeavesThePictureToTheCpu) {
    sweep_with_fallback(VK_ERROR_OUT_OF_DEVICE_MEMORY);
}

TEST_F(Drawing, ALostDeviceLeavesThePictureToTheCpu) {
    sweep_with_fallback(VK_ERROR_DEVICE_LOST);
}

TEST_F(Drawing, ALostDeviceLeavesEveryLayerToTheCpu) {
    for (const AovInfo& info : all_aovs())
        if (info.aov != Aov::light_groups && info.aov != Aov::motion)
            selection_.aovs.push_back(info.aov);
    sweep_with_fallback(VK_ERROR_DEVICE_LOST);
}

}  // namespace
}  // namespace hm::test
