// Which camera is used, and what happens to one that the file makes unusable.
#include "session/camera_choice.h"

#include <gtest/gtest.h>

namespace hm {
namespace {

Scene scene_with_cameras() {
    Scene scene;
    scene.cameras.resize(2);
    scene.cameras[1].name = "side";
    scene.nodes.resize(2);
    scene.nodes[0].camera = 0;
    scene.nodes[1].camera = 1;
    return scene;
}

Result<CameraChoice> choose(const Scene& scene, const std::string& camera) {
    ViewSettings view;
    view.camera = camera;
    return choose_camera(view, scene, Bounds{vec3(-1), vec3(1)}, 1);
}

TEST(CameraChoice, TheFirstOrTheNamedCamera) {
    const Scene scene = scene_with_cameras();
    EXPECT_EQ(choose(scene, "").value().name, "camera 0");
    EXPECT_EQ(choose(scene, "side").value().name, "camera 1 (side)");
    EXPECT_EQ(choose(scene, "none").value().name, "framing");
    EXPECT_EQ(choose(scene, "2").error().kind, ErrorKind::invalid_argument);
    EXPECT_EQ(choose(Scene(), "").value().name, "framing");
}

TEST(CameraChoice, AnUnusableCameraIsReplacedUnlessItIsNamed) {
    Scene scene = scene_with_cameras();
    scene.cameras[0].fault = Error{ErrorKind::invalid, "f", "/cameras/0/perspective/yfov", "is 0"};
    EXPECT_EQ(choose(scene, "").value().name, "framing");
    EXPECT_EQ(choose(scene, "none").value().name, "framing");
    EXPECT_EQ(choose(scene, "1").value().name, "camera 1 (side)");
    ASSERT_FALSE(choose(scene, "0"));
    EXPECT_EQ(choose(scene, "0").error().location, "/cameras/0/perspective/yfov");
}

}  // namespace
}  // namespace hm
