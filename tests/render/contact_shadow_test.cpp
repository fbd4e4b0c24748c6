// The shadow of a box on a floor, of any size and at any distance from the origin, against the
// closed form. Light that leaks below the box and shadow on its lit side both fail.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/camera.h"
#include "scene/origin.h"
#include "support/pictures.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Studio;

const vec3 kAlbedo(0.8f, 0.5f, 0.2f);

// A box on a floor, both below a root that is tilted and far away; the box's node is nested in one
// that is scaled up, and is drawn through an instance. All transforms are in double precision, and
// set_origin decides about floats.
struct BoxOnFloor {
    double size = 1;
    double away = 0;  // metres
    double tilt = 0;

    static constexpr double kHalf = 0.1;       // extent of the box
    static constexpr double kElevation = 0.6;  // of the sun, radians
    static constexpr float kView = 0.3f;       // half extent of the picture

    Scene scene() const {
        SceneBuilder b;
        const int material = b.material(test::lambertian(kAlbedo));
        const int floor = b.quad(vec3(-1, 0, 1), vec3(2, 0, 0), vec3(0, 0, -2), material);
        const int box = test::add_cube(b, false, material);
        glm::dmat4 root = glm::translate(glm::dmat4(1), glm::dvec3(0.7, 1, -0.4) * away);
        root = glm::rotate(root, tilt, glm::dvec3(0, 0, 1));
        add(b.scene, root, kUnset);
        add(b.scene, glm::scale(glm::dmat4(1), glm::dvec3(size)), 0).mesh = floor;
        add(b.scene, glm::scale(glm::dmat4(1), glm::dvec3(1000 * size)), 0);
        Node& nested =
            add(b.scene, glm::translate(glm::dmat4(1), glm::dvec3(0, kHalf / 1000, 0)), 2);
        nested.mesh = box;
        nested.instances = {glm::scale(glm::mat4(1), vec3(float(kHalf / 1000)))};
        b.scene.lights.emplace_back();
        b.scene.lights[0].kind = kLightDirectional;
        b.scene.lights[0].intensity = 4;
        // Shines along -z, which is turned down to the elevation: shadows fall towards -x.
        glm::dmat4 sun = glm::rotate(glm::dmat4(1), std::numbers::pi / 2, glm::dvec3(0, 1, 0));
        sun = glm::rotate(sun, -kElevation, glm::dvec3(1, 0, 0));
        add(b.scene, sun, 0).light = 0;
        Node& eye = add(b.scene, glm::translate(glm::dmat4(1), glm::dvec3(0, size, 0)), 0);
        eye.local = glm::rotate(eye.local, -std::numbers::pi / 2, glm::dvec3(1, 0, 0));
        set_origin(b.scene);
        return b.scene;
    }

    // The sun's share that a point of the picture gets, seen from above: the shadow is behind the
    // box, whose top is as bright as the floor. -1 on an edge.
    static double lit(double x, double z, double margin) {
        // The camera looks along the box's sides, and may see them.
        if (std::abs(std::max(std::abs(x), std::abs(z)) - kHalf) < margin) return -1;
        const double end = kHalf + 2 * kHalf / std::tan(kElevation);
        if (x > -kHalf || x < -end - margin || std::abs(z) > kHalf + margin) return 1;
        return x > -end + margin && std::abs(z) < kHalf - margin ? 0 : -1;
    }

  private:
    static Node& add(Scene& scene, const glm::dmat4& local, int parent) {
        Node& node = scene.nodes.emplace_back();
        node.local = local;
        node.parent = parent;
        return node;
    }
};

void expect_shadow(const BoxOnFloor& box) {
    constexpr uint kSide = 64;
    Studio studio(box.scene());
    Camera lens;
    lens.perspective = false;
    lens.xmag = lens.ymag = BoxOnFloor::kView * float(box.size);
    const CameraData camera =
        camera_from_node(lens, glm::mat4(world_transforms(studio.scene()).back()), 1);
    const test::Picture picture =
        studio.render(camera, {.width = kSide, .height = kSide, .samples = 4});
    const vec3 sun = kAlbedo * float(4 * std::sin(BoxOnFloor::kElevation) / std::numbers::pi);
    const double pixel = 2 * double(BoxOnFloor::kView) / kSide;
    for (uint y = 0; y < kSide; ++y)
        for (uint x = 0; x < kSide; ++x) {
            // Samples of a pixel are up to two pixels from its centre.
            const double lit =
                BoxOnFloor::lit((x + 0.5) * pixel - double(BoxOnFloor::kView),
                                (y + 0.5) * pixel - double(BoxOnFloor::kView), 2.5 * pixel);
            if (lit < 0) continue;
            const vec3 got = picture.pixels[y * kSide + x], right = sun * float(lit);
            ASSERT_LT(length(got - right), 1e-3f * length(sun))
                << "size " << box.size << ", away " << box.away << ", tilt " << box.tilt
                << ", pixel " << x << " " << y << ": " << got.x << " instead of " << right.x;
        }
}

// The shadow reaches up to the box: no light leaks below it, and no shadow is on its lit side.
TEST(ContactShadow, ABoxOnAFloorCastsItsShadow) {
    for (const double size : {1e-6, 1e-3, 1.0, 50.0, 1e3, 1e6, 1e9})
        for (const double tilt : {0.0, 0.3, -1.2}) {
            for (const double away : {0.0, 0.05, 30.0, 5000.0})
                expect_shadow({size, away * size, tilt});
            // Doubles resolve 2^-52 of 1e7 metres, so a millimetre to 2e-6.
            if (size >= 1e-3) expect_shadow({size, 1e7, tilt});
        }
}

}  // namespace
}  // namespace hm
