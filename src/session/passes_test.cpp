// render_passes with a renderer that fails in the middle.
#include "session/passes.h"

#include <gtest/gtest.h>

namespace hm {
namespace {

const Error kLost{ErrorKind::device_failed, "Vulkan", "trace", "VK_ERROR_DEVICE_LOST"};

// Counts samples like a GPU: the film has them from the next sync on. Fails at one sample.
class FailingRenderer final : public Renderer {
  public:
    explicit FailingRenderer(std::uint32_t fails_at) : fails_at_(fails_at) {}

    std::string device() const override { return "fake"; }
    Result<void> begin(const RenderJob&, Film& film) override {
        film_ = &film;
        return {};
    }
    Result<void> render(std::uint32_t begin, std::uint32_t end, RenderCounters& counters,
                        const std::atomic<bool>&) override {
        counters.samples += end - begin;
        waiting_ += float(end - begin);
        if (begin <= fails_at_ && fails_at_ < end) return tl::unexpected(kLost);
        return {};
    }
    Result<void> sync() override {
        film_->sums[0].weight += waiting_;
        waiting_ = 0;
        return {};
    }
    RendererReport report() const override { return {}; }

  private:
    std::uint32_t fails_at_;
    Film* film_ = nullptr;
    float waiting_ = 0;
};

struct Passes : testing::Test {
    Film film{{0, 0, 1, 1}};
    RenderCounters counters;
    PassPlan plan;

    // A pass takes one sample, and the film has it then.
    Passes() {
        plan.end = 1000;
        plan.pass_seconds = 0;
        plan.sync_every = 0;
    }
    Result<PassResult> draw(std::uint32_t fails_at) {
        FailingRenderer renderer(fails_at);
        const PassHooks hooks{.stop = [] { return false; }, .watch = [](const ProgressState&) {}};
        return render_passes(renderer, {}, film, counters, plan, hooks);
    }
};

TEST_F(Passes, KeepWhatTheFilmGotBeforeAFailure) {
    const Result<PassResult> passes = draw(7);
    ASSERT_TRUE(passes);
    ASSERT_TRUE(passes->failed);
    EXPECT_EQ(passes->failed->message, kLost.message);
    EXPECT_FALSE(passes->interrupted);
    EXPECT_EQ(film.mean_samples(), 7.0);
    EXPECT_EQ(counters.samples.load(), 7u);
}

TEST_F(Passes, FailWhereTheFilmGotNothing) {
    plan.sync_every = 60;
    film.sums[0].weight = 3;  // as resumed
    counters.samples = 3;
    const Result<PassResult> passes = draw(7);
    ASSERT_FALSE(passes);
    EXPECT_EQ(passes.error().message, kLost.message);
    EXPECT_EQ(film.mean_samples(), 3.0);
    EXPECT_EQ(counters.samples.load(), 3u);
}

TEST_F(Passes, EndWithAllSamples) {
    const Result<PassResult> passes = draw(1000);
    ASSERT_TRUE(passes);
    EXPECT_FALSE(passes->failed);
    EXPECT_EQ(film.mean_samples(), 1000.0);
    EXPECT_EQ(counters.samples.load(), 1000u);
}

}  // namespace
}  // namespace hm
