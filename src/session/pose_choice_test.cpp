// Which animation poses the scene, and when.
#include "session/pose_choice.h"

#include <gtest/gtest.h>

namespace hm {
namespace {

TEST(PoseChoice, TheFirstOrTheNamedAnimation) {
    Scene scene;
    Diagnostics diagnostics;
    AnimationSettings settings;
    EXPECT_FALSE(choose_pose(settings, scene, diagnostics).value());
    settings.at = 2;
    EXPECT_FALSE(choose_pose(settings, scene, diagnostics).value());
    EXPECT_EQ(diagnostics.warnings().size(), 1u);
    scene.animations = {{"walk", {}, {}}, {"run", {}, {}}};
    EXPECT_EQ(choose_pose(settings, scene, diagnostics).value()->animation, 0u);
    EXPECT_EQ(choose_pose(settings, scene, diagnostics).value()->seconds, 2.0);
    settings.animation = "run";
    EXPECT_EQ(choose_pose(settings, scene, diagnostics).value()->animation, 1u);
    settings.animation = "swim";
    EXPECT_EQ(choose_pose(settings, scene, diagnostics).error().kind, ErrorKind::invalid_argument);
}

}  // namespace
}  // namespace hm
