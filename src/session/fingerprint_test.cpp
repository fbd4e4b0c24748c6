// The settings stored with a film, and the text about their differences.
#include "session/fingerprint.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "session/camera_choice.h"

namespace hm {
namespace {

NamedValues values_of(const RenderSettings& settings, const RenderParams& params = {}) {
    RenderJob job;
    job.params = params;
    return picture_settings(settings, job, {}, {"hash", "", "", "none"});
}

TEST(Fingerprint, DifferencesNameBothValues) {
    RenderSettings one, other;
    EXPECT_EQ(differences(values_of(one), values_of(other), "now"), "");
    other.path.seed = 2;
    other.path.sampler = kSamplerIndependent;
    EXPECT_EQ(differences(values_of(one), values_of(other), "now"),
              "seed 0 (now 2), sampler sobol-owen (now independent)");
    other = one;
    other.view.fov = 30.0f;
    EXPECT_EQ(differences(values_of(one), values_of(other), "now"), "no fov (now 30)");
    EXPECT_EQ(differences(values_of(other), values_of(one), "now"), "fov 30 (now none)");
}

// A parameter that no named setting explains is noticed all the same.
TEST(Fingerprint, ParametersAreHashed) {
    RenderParams params{};
    params.diffuse_kind = 7;
    EXPECT_EQ(differences(values_of({}), values_of({}, params), "now"),
              "other settings of the renderer");
}

TEST(Fingerprint, AViewIsGivenAsSettings) {
    CameraData camera{};
    camera.kind = kCameraPerspective;
    camera.origin = {1, 2, 3};
    camera.forward = {0, 0, -1};
    camera.up = {0, 1, 0};
    camera.half_height = 1;
    camera.focus_distance = 2;
    const NamedValues view = view_of(camera, glm::dvec3(0));
    ASSERT_EQ(view.size(), 4u);
    EXPECT_EQ(view[0], (std::pair<std::string, std::string>("eye", "1,2,3")));
    EXPECT_EQ(view[1], (std::pair<std::string, std::string>("target", "1,2,1")));
    // A far scene's camera is relative to its origin, with more digits than a float has.
    camera.origin = {0.25f, -2, 3};
    const NamedValues far = view_of(camera, glm::dvec3(6000000, 0, -4000000));
    EXPECT_EQ(far[0].second, "6000000.25,-2,-3999997");
    EXPECT_EQ(far[1].second, "6000000.25,-2,-3999999");
    camera.kind = kCameraOrthographic;
    EXPECT_TRUE(view_of(camera, glm::dvec3(0)).empty());
}

}  // namespace
}  // namespace hm
