// Settings that do not fit together, and the settings of the frames of a sequence.
#include "session/settings.h"

#include <gtest/gtest.h>

namespace hm {
namespace {

TEST(Settings, DefaultsAreValid) {
    EXPECT_TRUE(check_settings(RenderSettings()));
}

TEST(Settings, ErrorsNameTheSetting) {
    const auto faulty = [](auto change) {
        RenderSettings settings;
        change(settings);
        const Result<void> checked = check_settings(settings);
        if (checked) return std::string("none");
        EXPECT_EQ(checked.error().kind, ErrorKind::invalid_argument);
        return checked.error().setting;
    };
    EXPECT_EQ(faulty([](auto& s) { s.frame.width = 0; }), "size");
    EXPECT_EQ(faulty([](auto& s) { s.frame.width = s.frame.height = 1u << 31; }), "size");
    EXPECT_EQ(faulty([](auto& s) { s.frame.crop = PixelRect{0, 0, 1281, 1}; }), "crop");
    EXPECT_EQ(faulty([](auto& s) { s.frame.crop = PixelRect{5, 0, 5, 1}; }), "crop");
    EXPECT_EQ(faulty([](auto& s) { s.path.filter_width = 0.0f; }), "filter-width");
    EXPECT_EQ(faulty([](auto& s) { s.view.up = vec3(0); }), "up");
    EXPECT_EQ(faulty([](auto& s) { s.view.eye = s.view.target = vec3(1); }), "target");
}

TEST(Settings, FramesHaveTheirTimeAndSeed) {
    RenderSettings settings;
    settings.animation.fps = 24;
    settings.path.seed = 5;
    const RenderSettings frame = settings_of_frame(settings, 36);
    EXPECT_EQ(frame.animation.at, 1.5f);
    EXPECT_EQ(frame.animation.frame, 36u);
    EXPECT_NE(frame.path.seed, 5u);
    EXPECT_EQ(settings_of_frame(settings, 0).path.seed, 5u);
}

}  // namespace
}  // namespace hm
