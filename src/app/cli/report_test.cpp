// A picture's metadata has the flags that shaped it, so that they can be typed again.
#include "app/cli/report.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hm::cli {
namespace {

TEST(Report, SettingsCanBeTypedAgain) {
    const char* arguments[] = {"himalaya", "render",       "demo:cornell",   "-o",
                               "out.exr",  "--aov=albedo", "--light-groups", "--seed=5"};
    const Result<CommandLine> line = parse_command_line(8, arguments);
    ASSERT_TRUE(line) << line.error().line();
    const Metadata metadata = picture_metadata(line->render->settings, RenderSummary{},
                                               metadata_texts(*line->render, RenderSummary{}));
    const auto settings = std::find_if(metadata.begin(), metadata.end(),
                                       [](const auto& pair) { return pair.first == "settings"; });
    ASSERT_NE(settings, metadata.end());
    EXPECT_NE(settings->second.find(" --seed 5 "), std::string::npos) << settings->second;
    EXPECT_TRUE(settings->second.ends_with(" --aov albedo --light-groups")) << settings->second;
}

}  // namespace
}  // namespace hm::cli
