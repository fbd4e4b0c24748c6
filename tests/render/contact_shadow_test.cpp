// The shadow of a box on a floor, of any size and at any distance from the origin, against the
// closed form. Light that leaks below the box and shadow on its lit side both fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

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

    Scene scene(bool sunny) const {
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
        if (sunny) add_sun(b.scene);
        Node& eye = add(b.scene, glm::translate(glm::dmat4(1), glm::dvec3(0, size, 0)), 0);
        eye.local = glm::rotate(eye.local, -std::numbers::pi / 2, glm::dvec3(1, 0, 0));
        set_origin(b.scene);
        return b.scene;
    }

    static void add_sun(Scene& scene) {
        scene.lights.emplace_back();
        scene.lights[0].kind = kLightDirectional;
        scene.lights[0].intensity = 4;
        // Shines along -z, which is turned down to the elevation: shadows fall towards -x.
        glm::dmat4 sun = glm::rotate(glm::dmat4(1), std::numbers::pi / 2, glm::dvec3(0, 1, 0));
        sun = glm::rotate(sun, -kElevation, glm::dvec3(1, 0, 0));
        add(scene, sun, 0).light = 0;
    }

    // The camera is the last node.
    CameraData camera(const Scene& placed) const {
        Camera lens;
        lens.perspective = false;
        lens.xmag = lens.ymag = kView * float(size);
        return camera_from_node(lens, glm::mat4(world_transforms(placed).back()), 1);
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

    // The share of a uniform sky that a point of the floor, outside of the box, sees: Lambert's
    // formula for the sides of the box that face it.
    static double sky(double x, double z) {
        const double h = 2 * kHalf;
        double covered = 0;
        const auto side = [&](double ax, double az, double bx, double bz) {
            const glm::dvec3 corners[] = {
                {ax - x, 0, az - z}, {bx - x, 0, bz - z}, {bx - x, h, bz - z}, {ax - x, h, az - z}};
            double sum = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const glm::dvec3 a = normalize(corners[k]), b = normalize(corners[(k + 1) % 4]);
                const glm::dvec3 n = cross(a, b);
                if (length(n) > 0)
                    sum += std::acos(std::clamp(dot(a, b), -1.0, 1.0)) * n.y / length(n);
            }
            covered += std::abs(sum) / (2 * std::numbers::pi);
        };
        if (std::abs(x) > kHalf)
            side(std::copysign(kHalf, x), -kHalf, std::copysign(kHalf, x), kHalf);
        if (std::abs(z) > kHalf)
            side(-kHalf, std::copysign(kHalf, z), kHalf, std::copysign(kHalf, z));
        return 1 - covered;
    }

  private:
    static Node& add(Scene& scene, const glm::dmat4& local, int parent) {
        Node& node = scene.nodes.emplace_back();
        node.local = local;
        node.parent = parent;
        return node;
    }
};

std::string describe(const BoxOnFloor& box) {
    return "size " + std::to_string(box.size) + ", away " + std::to_string(box.away) + ", tilt " +
           std::to_string(box.tilt);
}

void expect_shadow(const BoxOnFloor& box) {
    constexpr uint kSide = 64;
    Studio studio(box.scene(true));
    const test::Picture picture =
        studio.render(box.camera(studio.scene()),
                      {.width = kSide, .height = kSide, .samples = 4, .strategy = kStrategyBsdf});
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
                << describe(box) << ", pixel " << x << " " << y << ": " << got.x << " instead of "
                << right.x;
        }
}

template <class F>
void for_all_boxes(const F& check) {
    for (int power = -12; power <= 18; power += test::backend().thorough ? 3 : 6)
        for (const double tilt : {0.0, 0.3, -1.2}) {
            const double size = std::pow(10.0, 0.5 * power);
            for (const double away : {0.0, 0.05, 30.0, 5000.0})
                check(BoxOnFloor{size, away * size, tilt});
            // Doubles resolve 2^-52 of 1e7 metres, so a millimetre to 2e-6.
            if (size >= 1e-3) check(BoxOnFloor{size, 1e7, tilt});
        }
}

// The shadow reaches up to the box: no light leaks below it, and no shadow is on its lit side.
TEST(ContactShadow, ABoxOnAFloorCastsItsShadow) {
    for_all_boxes(expect_shadow);
}

// Under a sky the floor darkens towards the box. A sample sees the sky or the box, so the variance
// of the mean is known: 4.5 standard errors, in a ring along the box and over the whole floor.
TEST(ContactShadow, ABoxUnderTheSkyDarkensTheFloor) {
    constexpr uint kSide = 64, kSamples = 16;
    constexpr double kPixel = 2 * double(BoxOnFloor::kView) / kSide;
    for_all_boxes([](const BoxOnFloor& box) {
        Studio studio(box.scene(false), test::constant_environment(vec3(1)));
        const test::Picture picture = studio.render(
            box.camera(studio.scene()),
            {.width = kSide, .height = kSide, .samples = kSamples, .strategy = kStrategyBsdf});
        for (const double reach : {0.03, 1.0}) {
            double off = 0, variance = 0, count = 0;
            for (uint i = 0; i < kSide * kSide; ++i) {
                const double x = (i % kSide + 0.5) * kPixel - double(BoxOnFloor::kView);
                const double z = (i / kSide + 0.5) * kPixel - double(BoxOnFloor::kView);
                const double from_box = std::max(std::abs(x), std::abs(z)) - BoxOnFloor::kHalf;
                if (from_box < kPixel || from_box > reach) continue;
                const double sky = BoxOnFloor::sky(x, z);
                off += double(picture.pixels[i].x) / double(kAlbedo.x) - sky;
                variance += sky * (1 - sky) / kSamples;
                count += 1;
            }
            ASSERT_LT(std::abs(off), 4.5 * std::sqrt(variance) + 1e-3 * count)
                << describe(box) << ", within " << reach << ": " << off / count;
        }
    });
}

}  // namespace
}  // namespace hm
