// What must not change a bit of a picture on one device, and that independent samples agree with
// the CPU's.
#include <gtest/gtest.h>

#include <cstring>

#include "gpu/path_tracer.h"
#include "gpu/renderers.h"
#include "support/pictures.h"

namespace hm::test {

namespace {

bool same_bits(const std::vector<PixelSum>& a, const std::vector<PixelSum>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

void add_samples(Renderer& renderer, std::uint32_t begin, std::uint32_t end, bool cancelled) {
    RenderCounters counters;
    ASSERT_TRUE(renderer.render(begin, end, counters, std::atomic<bool>(cancelled)));
    ASSERT_TRUE(renderer.sync());
}

// The feature scene with a clamp, so that all sums are used.
struct Bits : ::testing::Test {
    TestScene scene;
    Duel duel{scene.flat};
    RenderJob job = make_job(scene.flat, scene.camera);

    Bits() { job.params.max_radiance = 2; }
    void TearDown() override { expect_no_messages(); }
};

using RendererBits = Bits;

TEST_F(RendererBits, PassesAndResumingChangeNone) {
    const Film once = draw(duel.gpu(), job);
    EXPECT_GT(once.removed_luminance(), 0.0);
    Film film(once.crop);
    ASSERT_TRUE(duel.gpu().begin(job, film));
    add_samples(duel.gpu(), 0, 1, false);
    add_samples(duel.gpu(), 1, 1, false);
    add_samples(duel.gpu(), 1, 6, true);  // cancelled before it began
    add_samples(duel.gpu(), 1, 6, false);
    EXPECT_EQ(film.mean_samples(), 6.0);

    Film resumed = film;  // as a checkpoint brings it back
    ASSERT_TRUE(duel.gpu().begin(job, resumed));
    add_samples(duel.gpu(), 6, kPictureSamples, false);
    EXPECT_TRUE(same_bits(resumed.sums, once.sums));
}

TEST_F(RendererBits, CropsChangeNone) {
    const Film whole = draw(duel.gpu(), job);
    const PixelRect crop = {17, 9, 50, 41};
    const Film part = draw(duel.gpu(), job, crop);
    std::vector<PixelSum> expected;
    for (std::uint32_t y = crop.y0; y < crop.y1; ++y)
        for (std::uint32_t x = crop.x0; x < crop.x1; ++x)
            expected.push_back(whole.sums[y * kPictureSize + x]);
    EXPECT_TRUE(same_bits(part.sums, expected));
}

// Independently seeded pictures of both devices are samples of one distribution. Unlike parity,
// this does not depend on both taking the same paths.
TEST_F(RendererBits, IndependentSamplesAgreeWithTheCpu) {
    job.params.width = job.params.height = 24;
    job.params.sampler_kind = kSamplerIndependent;
    job.params.max_radiance = 0;
    const auto replicates = [&](Renderer& renderer, std::uint32_t first_seed) {
        std::vector<Picture> pictures;
        for (std::uint32_t i = 0; i < 16; ++i) {
            job.params.seed = first_seed + i;
            const Film film = draw(renderer, job);
            Picture picture{24, 24, {}, {}};
            for (const vec4& p : means_of(film)) {
                picture.pixels.emplace_back(p);
                picture.alpha.push_back(p.w);
            }
            pictures.push_back(std::move(picture));
        }
        return pictures;
    };
    expect_same_pictures(replicates(duel.gpu(), 100), replicates(duel.cpu(), 200), "GPU and CPU");
}

}  // namespace

}  // namespace hm::test
