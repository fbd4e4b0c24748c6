// Device choice, its messages, and the fallback, with fake devices.
#include "session/devices.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "session/fallback.h"

namespace hm {
namespace {

const Error kLost{ErrorKind::device_failed, "", "", "vkQueueSubmit2: VK_ERROR_DEVICE_LOST"};
const Error kNone{ErrorKind::no_device, "", "", "no Vulkan loader"};

// Adds its step to each pixel per sample. Keeps sums of its own until sync, as a GPU does; fails at
// the call of the given number, if any.
class FakeRenderer final : public Renderer {
  public:
    FakeRenderer(std::string name, float step, int fails_at = 0)
        : name_(std::move(name)), step_(step), fails_at_(fails_at) {}

    std::string device() const override { return name_; }
    Result<void> begin(const RenderJob&, Film& film) override {
        film_ = &film;
        sums_ = film.sums;
        return call();
    }
    Result<void> render(std::uint32_t begin, std::uint32_t end, RenderCounters& counters,
                        const std::atomic<bool>& cancel) override {
        if (cancel) end = begin;
        for (PixelSum& sum : sums_) {
            sum.radiance.x += step_ * float(end - begin);
            sum.weight += float(end - begin);
        }
        counters.samples += (end - begin) * sums_.size();
        counters.rays += (end - begin) * sums_.size();
        return call();
    }
    Result<void> sync() override {
        HM_TRY(call());
        film_->sums = sums_;
        return {};
    }
    RendererReport report() const override {
        RendererReport r;
        r.device = name_;
        return r;
    }

  private:
    Result<void> call() {
        if (++calls_ == fails_at_) return tl::unexpected(kLost);
        return {};
    }

    std::string name_;
    float step_;
    int fails_at_, calls_ = 0;
    Film* film_ = nullptr;
    std::vector<PixelSum> sums_;
};

class FakeDevice final : public RenderDevice {
  public:
    std::string name() const override { return "Fake 3000 (Vulkan)"; }
    Result<std::unique_ptr<Renderer>> load(const FlatScene&) override {
        return tl::unexpected(kLost);
    }
};

Result<std::unique_ptr<RenderDevice>> open_fake(std::optional<std::uint32_t>) {
    return std::make_unique<FakeDevice>();
}
Result<std::unique_ptr<RenderDevice>> open_none(std::optional<std::uint32_t>) {
    return tl::unexpected(kNone);
}

struct Lines {
    std::vector<std::string> all;
    Note note() {
        return [this](std::string_view line) { all.emplace_back(line); };
    }
};

TEST(DeviceChoice, AutoTakesTheGpuOrSaysWhyNot) {
    Lines lines;
    const auto gpu = choose_device({}, 1, open_fake, lines.note());
    ASSERT_TRUE(gpu);
    EXPECT_EQ((*gpu)->name(), "Fake 3000 (Vulkan)");
    const auto cpu = choose_device({}, 1, open_none, lines.note());
    ASSERT_TRUE(cpu);
    EXPECT_EQ((*cpu)->name(), "CPU");
    EXPECT_EQ(lines.all, (std::vector<std::string>{"drawing on Fake 3000 (Vulkan)",
                                                   "drawing on the CPU: no Vulkan loader"}));
}

TEST(DeviceChoice, VulkanNeverFallsBack) {
    Lines lines;
    const DeviceChoice wanted{DeviceChoice::Kind::vulkan, {}};
    const auto none = choose_device(wanted, 1, open_none, lines.note());
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::no_device);
    const auto gpu = choose_device(wanted, 1, open_fake, lines.note());
    ASSERT_TRUE(gpu);
    const auto renderer = (*gpu)->load({});
    ASSERT_FALSE(renderer);
    EXPECT_EQ(renderer.error().message, kLost.message);
}

TEST(DeviceChoice, AnExplicitCpuAsksNobodyAndSaysNothing) {
    Lines lines;
    const auto cpu = choose_device({DeviceChoice::Kind::cpu, {}}, 1, nullptr, lines.note());
    ASSERT_TRUE(cpu);
    EXPECT_TRUE(lines.all.empty());
}

TEST(DeviceChoice, AutoGivesASceneThatTheGpuCannotHoldToTheCpu) {
    Lines lines;
    const auto device = choose_device({}, 1, open_fake, lines.note());
    ASSERT_TRUE(device);
    FlatScene empty;
    empty.mesh_first_geometry = {0};
    const auto renderer = (*device)->load(empty);
    ASSERT_TRUE(renderer);
    EXPECT_EQ((*renderer)->report().kind, "cpu");
    EXPECT_EQ((*device)->name(), "CPU");
    EXPECT_EQ(lines.all.back(), "continuing with the CPU: vkQueueSubmit2: VK_ERROR_DEVICE_LOST");
}

// Calls of the first renderer: begin, render, sync, render, render, sync. Whichever fails, the film
// gets six samples a pixel, those of the last sync from the first renderer.
TEST(Fallback, NoSampleIsLostOrDrawnTwiceWhereverTheDeviceFails) {
    for (int fails_at = 0; fails_at <= 6; ++fails_at) {
        std::string told;
        FallbackRenderer renderer(std::make_unique<FakeRenderer>("first", 1.0f, fails_at),
                                  [&](const Error& error) -> Result<std::unique_ptr<Renderer>> {
                                      told = error.message;
                                      return std::make_unique<FakeRenderer>("second", 10.0f);
                                  });
        Film film({0, 0, 2, 1});
        RenderCounters counters;
        const std::atomic<bool> cancel{false};
        ASSERT_TRUE(renderer.begin({}, film));
        ASSERT_TRUE(renderer.render(0, 2, counters, cancel));
        ASSERT_TRUE(renderer.sync());
        ASSERT_TRUE(renderer.render(2, 3, counters, cancel));
        ASSERT_TRUE(renderer.render(3, 6, counters, cancel));
        ASSERT_TRUE(renderer.sync());
        const float from_first = fails_at == 0 ? 6.0f : fails_at <= 3 ? 0.0f : 2.0f;
        for (const PixelSum& sum : film.sums) {
            EXPECT_EQ(sum.weight, 6.0f) << fails_at;
            EXPECT_EQ(sum.radiance.x, from_first + 10 * (6 - from_first)) << fails_at;
        }
        EXPECT_EQ(counters.samples.load(), 12u) << fails_at;
        EXPECT_EQ(told, fails_at == 0 ? "" : kLost.message);
        EXPECT_EQ(renderer.report().device, fails_at == 0   ? "first"
                                            : fails_at <= 3 ? "second"
                                                            : "first, then second");
    }
}

// Cancelled in its first pass: for a checkpoint, after which it goes on, or because time is up.
TEST(Fallback, ACancelledPictureGetsItsFirstSampleAndMayGoOn) {
    FallbackRenderer renderer(std::make_unique<FakeRenderer>("first", 1.0f, 2),
                              [](const Error&) -> Result<std::unique_ptr<Renderer>> {
                                  return std::make_unique<FakeRenderer>("second", 10.0f);
                              });
    Film film({0, 0, 2, 1});
    RenderCounters counters;
    ASSERT_TRUE(renderer.begin({}, film));
    ASSERT_TRUE(renderer.render(0, 4, counters, std::atomic<bool>(true)));
    ASSERT_TRUE(renderer.sync());
    EXPECT_EQ(film.mean_samples(), 1.0);
    EXPECT_EQ(counters.samples.load(), 2u);
    ASSERT_TRUE(renderer.render(1, 4, counters, std::atomic<bool>(false)));
    ASSERT_TRUE(renderer.sync());
    EXPECT_EQ(film.mean_samples(), 4.0);
    EXPECT_EQ(renderer.report().device, "second");
}

TEST(Fallback, TheSecondFailureIsFinal) {
    FallbackRenderer renderer(std::make_unique<FakeRenderer>("first", 1.0f, 1),
                              [](const Error&) -> Result<std::unique_ptr<Renderer>> {
                                  return std::make_unique<FakeRenderer>("second", 10.0f, 2);
                              });
    Film film({0, 0, 1, 1});
    RenderCounters counters;
    ASSERT_TRUE(renderer.begin({}, film));
    EXPECT_FALSE(renderer.render(0, 1, counters, std::atomic<bool>(false)));
}

}  // namespace
}  // namespace hm
