// Which animations pose the scene, and when.
#include "session/pose_choice.h"

#include <gtest/gtest.h>

namespace hm {
namespace {

using Indices = std::vector<std::size_t>;

TEST(PoseChoice, TheFirstOrTheNamedAnimation) {
    Scene scene;
    Diagnostics diagnostics;
    AnimationSettings settings;
    EXPECT_FALSE(choose_pose(settings, scene, diagnostics).value());
    settings.at = 2;
    EXPECT_FALSE(choose_pose(settings, scene, diagnostics).value());
    EXPECT_EQ(diagnostics.warnings().size(), 1u);
    scene.animations = {{"walk", {}, {}}, {"run", {}, {}}};
    EXPECT_EQ(choose_pose(settings, scene, diagnostics).value()->animations, Indices{0});
    EXPECT_EQ(choose_pose(settings, scene, diagnostics).value()->seconds, 2.0);
    settings.animation = "run";
    EXPECT_EQ(choose_pose(settings, scene, diagnostics).value()->animations, Indices{1});
    settings.animation = "swim";
    EXPECT_EQ(choose_pose(settings, scene, diagnostics).error().kind, ErrorKind::invalid_argument);
}

TEST(PoseChoice, AnimationsLeftOutAreReported) {
    Scene scene;
    scene.animations = {{"walk", {}, {}}, {"run", {}, {}}};
    AnimationSettings settings;
    Diagnostics rest, first, named;
    EXPECT_FALSE(choose_pose(settings, scene, rest).value());
    EXPECT_TRUE(rest.warnings().empty());
    settings.at = 0;
    EXPECT_TRUE(choose_pose(settings, scene, first));
    ASSERT_EQ(first.warnings().size(), 1u);
    EXPECT_NE(first.warnings()[0].message.find("first of 2 animations, \"walk\""),
              std::string::npos);
    settings.animation = "walk";
    EXPECT_TRUE(choose_pose(settings, scene, named));
    EXPECT_TRUE(named.warnings().empty());
}

TEST(PoseChoice, AllAnimations) {
    Scene scene;
    scene.animations = {{"a", {}, {{.node = 0}}}, {"b", {}, {{.node = 1}}}};
    AnimationSettings settings;
    settings.animation = "all";
    Diagnostics apart, shared, none;
    EXPECT_EQ(choose_pose(settings, scene, apart).value()->animations, (Indices{0, 1}));
    EXPECT_TRUE(apart.warnings().empty());
    scene.animations.push_back({"c", {}, {{.node = 1}, {.node = 2}}});
    EXPECT_EQ(choose_pose(settings, scene, shared).value()->animations, (Indices{0, 1, 2}));
    ASSERT_EQ(shared.warnings().size(), 1u);
    EXPECT_NE(shared.warnings()[0].message.find("(properties: 1)"), std::string::npos);
    scene.animations.clear();
    EXPECT_FALSE(choose_pose(settings, scene, none).value());
    EXPECT_EQ(none.warnings().size(), 1u);
}

}  // namespace
}  // namespace hm
