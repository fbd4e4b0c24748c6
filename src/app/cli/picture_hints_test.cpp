// Each hint where its flag helps, and none where the picture is fine.
#include "app/cli/picture_hints.h"

#include <gtest/gtest.h>

namespace hm::cli {
namespace {

// A picture of one radiance, with a path of three rays per sample.
struct Picture {
    RenderOptions options;
    RenderSummary summary;
    Film film{PixelRect{0, 0, 8, 4}};

    explicit Picture(float radiance) {
        options.outputs = {"picture.png"};
        for (PixelSum& sum : film.sums) {
            sum.radiance = vec3(2 * radiance);
            sum.alpha = sum.weight = 2;
        }
        summary.camera = "camera 0";
        summary.environment = "default";
        summary.samples = 64;
        summary.rays = 192;
        summary.mean_luminance = film.mean_luminance();
    }
    std::string hint() const { return picture_hint(options, summary, film).value_or(""); }
    bool mentions(const char* text) const { return hint().find(text) != std::string::npos; }
};

TEST(PictureHint, NoneForAGoodPicture) {
    EXPECT_EQ(Picture(0.3f).hint(), "");
}

TEST(PictureHint, ClippingAsksForAutoExposure) {
    Picture bright(50);
    EXPECT_TRUE(bright.mentions("100 % of the pixels"));
    EXPECT_TRUE(bright.mentions("--exposure auto"));
    bright.options.outputs = {"picture.exr"};
    EXPECT_EQ(bright.hint(), "");
    bright.options.outputs = {"picture.exr", "picture.PNG"};
    EXPECT_NE(bright.hint(), "");
    bright.options.settings.display.exposure = -8.0f;
    EXPECT_EQ(bright.hint(), "");
    bright.options.settings.display.exposure.reset();
    EXPECT_EQ(bright.hint(), "");
    // Half of the pixels may clip.
    Picture half(50);
    for (std::size_t i = 0; i < half.film.sums.size() / 2; ++i)
        half.film.sums[i].radiance = vec3(0.5f);
    EXPECT_EQ(half.hint(), "");
    half.film.sums.back().radiance = half.film.sums[0].radiance = vec3(100, 0, 0);
    EXPECT_TRUE(half.mentions("53 %"));
}

TEST(PictureHint, DarknessAsksForAutoExposure) {
    EXPECT_TRUE(Picture(1e-6f).mentions("--exposure auto"));
}

TEST(PictureHint, BlackAsksForLight) {
    Picture black(0);
    black.summary.environment = "none";
    EXPECT_TRUE(black.mentions("--punctual off"));
    black.options.settings.light.environment = EnvironmentKind::none;
    EXPECT_TRUE(black.mentions("without --env none"));
}

TEST(PictureHint, MissedSceneAsksForAnotherCamera) {
    Picture missed(0.3f);
    missed.summary.rays = missed.summary.samples;
    EXPECT_TRUE(missed.mentions("--camera none"));
    missed.summary.camera = "framing";
    EXPECT_TRUE(missed.mentions("--eye"));
    missed.summary.scene.paths_may_end = true;  // an unlit surface may have been hit
    EXPECT_EQ(missed.hint(), "");
}

TEST(PictureHint, SequenceGetsOne) {
    Picture bright(50);
    bright.options.frames = FrameRange{3, 5};
    bright.options.settings.animation.frame = 3;
    EXPECT_NE(bright.hint(), "");
    bright.options.settings.animation.frame = 4;
    EXPECT_EQ(bright.hint(), "");
}

}  // namespace
}  // namespace hm::cli
