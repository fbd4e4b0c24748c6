// A scene millions of metres from the origin looks like the same scene at the origin.
#include <gtest/gtest.h>

#include "compare/z_test.h"
#include "output/layers.h"
#include "scene/camera.h"
#include "scene/origin.h"
#include "support/pictures.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Shot;
using test::Studio;

Node node_at(const glm::dvec3& translation, const glm::dvec4& rotation = {0, 0, 0, 1},
             const glm::dvec3& scale = glm::dvec3(1)) {
    Node node;
    node.rest = Transform{translation, rotation, scale};
    node.local = to_matrix(*node.rest);
    return node;
}

// A floor, a box on it and a ring of instanced plates under a lamp and a sky, below one root. Sizes
// and positions are of no particular grid.
Scene yard(const Node& root) {
    SceneBuilder b;
    const int floor = b.quad(vec3(-4, 0, 4), vec3(8, 0, 0), vec3(0, 0, -8),
                             b.material(test::lambertian(vec3(0.6f, 0.5f, 0.4f))));
    const int box = test::add_cube(b, false, b.material(test::lambertian(vec3(0.3f, 0.5f, 0.8f))));
    Scene scene = b.scene;
    scene.nodes = {root};
    const auto add = [&](Node node) {
        node.parent = 0;
        scene.nodes.push_back(std::move(node));
    };
    Node ground = node_at({0.013, 0.027, -0.041});
    ground.mesh = floor;
    add(ground);
    Node cube = node_at({-1.127, 0.5513, 0.337}, {0, 0.3, 0, 1}, glm::dvec3(0.521));
    cube.mesh = box;
    add(cube);
    Node plates = node_at({1.271, 0.1, 0.119}, {0.1, -0.2, 0.05, 0.9});
    plates.mesh = box;
    for (const float x : {-0.7f, 0.0f, 0.7f})
        plates.instances.push_back(glm::scale(glm::translate(glm::mat4(1), vec3(x, 0.9f, x * x)),
                                              vec3(0.2f, 0.03f, 0.3f)));
    add(plates);
    scene.lights.emplace_back().intensity = 30;
    Node lamp = node_at({0.713, 3.291, 1.137});
    lamp.light = 0;
    add(lamp);
    scene.cameras.emplace_back();
    Node eye = node_at({0.317, 3.7, 7.9}, {-0.2, 0.02, 0, 1});
    eye.camera = 0;
    add(eye);
    set_origin(scene);
    return scene;
}

// The mean of 16 pictures, and its variance per pixel.
struct Measured {
    FloatImage mean, variance;
};

Measured measure(Studio& studio, const CameraData& camera, uint first_seed) {
    constexpr uint kSide = 48;
    const Shot shot{.width = kSide, .height = kSide, .samples = 64, .bounces = 3};
    const std::vector<test::Picture> pictures =
        test::replicate(studio, camera, shot, 16, first_seed);
    const double n = double(pictures.size());
    Measured out{FloatImage(kSide, kSide), FloatImage(kSide, kSide)};
    for (std::size_t i = 0; i < pictures[0].pixels.size(); ++i) {
        glm::dvec3 sum(0), squares(0);
        for (const test::Picture& p : pictures)
            sum += glm::dvec3(p.pixels[i]);
        for (const test::Picture& p : pictures) {
            const glm::dvec3 d = glm::dvec3(p.pixels[i]) - sum / n;
            squares += d * d;
        }
        const glm::dvec3 mean = sum / n, variance = squares / (n * (n - 1));
        out.mean.pixels[i] = {float(mean.x), float(mean.y), float(mean.z), 1};
        out.variance.pixels[i] = {float(variance.x), float(variance.y), float(variance.z), 1};
    }
    return out;
}

void expect_same(const Node& far_root) {
    Scene near = yard(node_at({0, 0, 0})), far = yard(far_root);
    ASSERT_FALSE(near.double_precision);
    ASSERT_TRUE(far.double_precision);
    Studio a(near, test::constant_environment(vec3(0.4f)));
    Studio b(far, test::constant_environment(vec3(0.4f)));
    const auto file_camera = [](const Studio& s) {
        const Scene& scene = s.scene();
        return camera_from_node(scene.cameras[0], glm::mat4(world_transforms(scene).back()), 1);
    };
    const auto framing = [](const Studio& s) { return camera_framing(s.flat().bounds, 0.8f, 1); };
    const auto compare = [&](const char* what, const auto& camera_of) {
        const Measured here = measure(a, camera_of(a), 1);
        const Measured there = measure(b, camera_of(b), 1001);
        const ZTest z = z_test(here.mean, here.variance, there.mean, there.variance);
        EXPECT_TRUE(z.agree()) << what << ": |z| up to " << z.largest << " in " << z.beyond
                               << " places, allowed " << z.threshold << "; the whole "
                               << z.whole[0];
    };
    compare("the file's camera", file_camera);
    compare("the automatic camera", framing);
}

// UTM coordinates: easting and northing of millions of metres.
TEST(Far, AnOffsetOfTheRootChangesNothing) {
    expect_same(node_at({691000.40625, 519.7, -5334000.3}));
}

// The axis-aligned bounding box, and with it the automatic camera, would turn with the root.
TEST(Far, NodesThatCancelEachOther) {
    const glm::dvec4 turn(0.11, 0.31, -0.17, 0.93);
    const glm::dvec3 far(4075539.812, 931735.427, 4801629.213);  // on the Earth's surface
    const Node out = node_at(far, turn);
    Scene scene = yard(node_at({0, 0, 0}));
    Scene there = scene;
    // Every child is first moved to the centre of the Earth by the inverse of its parent.
    there.nodes[0] = out;
    for (std::size_t i = 1; i < there.nodes.size(); ++i) {
        there.nodes[i].rest.reset();
        there.nodes[i].local = glm::inverse(out.local) * to_matrix(*scene.nodes[i].rest);
    }
    set_origin(there);
    ASSERT_TRUE(there.double_precision);
    ASSERT_EQ(there.origin, glm::dvec3(0));
    const std::vector<glm::dmat4> expected = world_transforms(scene);
    const std::vector<glm::dmat4> got = world_transforms(there);
    // 2^-53 of 6e6, of which a few sums are made; floats would be off by 0.5.
    for (std::size_t i = 1; i < got.size(); ++i)
        for (glm::length_t c = 0; c < 4; ++c)
            EXPECT_LT(glm::length(got[i][c] - expected[i][c]), 2e-7) << i << ", column " << c;
}

// The position AOV is in the file's coordinates, to their rounding: half a metre at 5e6.
TEST(Far, PositionsAreTheFiles) {
    Studio studio(yard(node_at({691000, 519, -5334000})));
    CameraData camera = test::flat_camera(vec3(0), vec3(0, 1, 0), 40);  // the floor's edge is at 4
    camera.origin.y = 20;
    const Film film =
        studio.render_film(camera, {.width = 20, .height = 20, .samples = 4}, {Aov::position});
    const LayeredImage layers = film_layers(film, {20, 20, true, {}, {}, studio.scene().origin});
    const Layer* position = layers.find("position");
    ASSERT_NE(position, nullptr);
    const std::size_t middle = 20 * 10 + 10;
    EXPECT_NEAR(position->find("X")->values[middle], 691000, 5);
    EXPECT_NEAR(position->find("Y")->values[middle], 519.5, 1);
    EXPECT_NEAR(position->find("Z")->values[middle], -5334000, 5);
    EXPECT_EQ(position->find("X")->values[0], 0);  // hits nothing
}

}  // namespace
}  // namespace hm
