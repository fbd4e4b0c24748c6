// Frame ranges, file names and the options of one frame of a sequence.
#include "app/cli/frames.h"

#include <gtest/gtest.h>

#include <set>

namespace hm::cli {
namespace {

TEST(Frames, Ranges) {
    const auto range = parse_frames("3:12");
    ASSERT_TRUE(range);
    EXPECT_EQ(range->first, 3u);
    EXPECT_EQ(range->last, 12u);
    EXPECT_TRUE(parse_frames("7:7"));
    for (const char* wrong : {"", "5", "5:", ":5", "9:3", "-1:3", "1:2:3", "a:b", "1:100000000"})
        EXPECT_FALSE(parse_frames(wrong)) << wrong;
}

TEST(Frames, FileNames) {
    EXPECT_EQ(frame_path("out/a.####.png", 7), "out/a.0007.png");
    EXPECT_EQ(frame_path("#.exr", 123), "123.exr");
    EXPECT_TRUE(has_frame_pattern("a#b.png"));
    EXPECT_FALSE(has_frame_pattern("a.png"));
    EXPECT_FALSE(has_frame_pattern("##/a.png"));
    EXPECT_FALSE(has_frame_pattern("#a#.png"));
}

TEST(Frames, OptionsOfOneFrame) {
    RenderOptions options;
    options.frames = FrameRange{0, 48};
    options.settings.animation.fps = 24;
    options.settings.path.seed = 5;
    options.outputs = {"f##.png", "g#.exr"};
    options.given = {{"frames", "0:48"}, {"spp", "4"}, {"seed", "5"}};
    const RenderOptions frame = frame_options(options, 36);
    EXPECT_EQ(frame.settings.animation.at, 1.5f);
    EXPECT_EQ(frame.outputs[0], "f36.png");
    EXPECT_EQ(frame.outputs[1], "g36.exr");
    EXPECT_EQ(frame.given.size(), 3u);
    EXPECT_EQ(frame.given[1].first, "at");
    EXPECT_EQ(frame_options(options, 0).settings.path.seed, 5u);
    std::set<std::uint32_t> seeds;
    for (std::uint32_t i = 0; i <= 1000; ++i)
        seeds.insert(frame_options(options, i).settings.path.seed);
    EXPECT_EQ(seeds.size(), 1001u);
}

}  // namespace
}  // namespace hm::cli
