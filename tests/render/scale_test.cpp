// Floors, gaps and lamps of any size and at any distance from the origin, against closed forms.
// Tests ray origin offsets: too small an offset causes self-intersection (shadow acne), too large a
// one misses objects that touch the surface (light leaks). No expected value depends on the size.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "scene/camera.h"
#include "support/pictures.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Shot;
using test::Studio;

const vec3 kAlbedo(0.8f, 0.5f, 0.2f);

enum class How { vertices, translated, scaled, instanced, nested };

// A square floor centered at `center` with half extent `size`, tilted about z. Its size and
// position come from its vertices or from its node. If instanced, a second copy far below keeps it
// in a BVH of its own; if nested, its node is scaled down below one that is scaled up, too.
struct Floor {
    float size = 1;
    vec3 center{0};
    float tilt = 0;
    How how = How::vertices;

    vec3 x() const { return vec3(std::cos(tilt), std::sin(tilt), 0); }
    vec3 normal() const { return vec3(-std::sin(tilt), std::cos(tilt), 0); }

    void add(SceneBuilder& b) const {
        const float s = how == How::vertices || how == How::translated ? size : 1.0f;
        const vec3 middle = how == How::vertices ? center : vec3(0);
        const vec3 z(0, 0, -1);
        const int mesh = b.quad(middle - x() * s - z * s, x() * (2 * s), z * (2 * s),
                                b.material(test::lambertian(kAlbedo)));
        glm::mat4 place(1);
        if (how != How::vertices) place = glm::translate(place, center);
        if (how == How::scaled || how == How::instanced) place = glm::scale(place, vec3(size));
        if (how == How::nested) return add_nested(b, mesh, place);
        b.place(mesh, place);
        if (how == How::instanced)
            b.place(mesh, glm::translate(glm::mat4(1), normal() * (-100 * size)) * place);
    }

    // Sees the middle of the floor from above at an angle; pixels are 1/100 of its size.
    CameraData camera() const {
        CameraData c = camera_look_at(center + (normal() * 0.8f + x() * 0.3f) * size, center,
                                      vec3(0, 0, -1), 1, 1);
        c.kind = kCameraOrthographic;
        c.half_width = c.half_height = 0.3f * size;
        return c;
    }

    // Sees the middle straight from above, from `height`.
    CameraData camera_above(float height) const {
        CameraData c = camera_look_at(center + normal() * size, center, vec3(0, 0, -1), 1, 1);
        c.kind = kCameraOrthographic;
        c.half_width = c.half_height = 0.3f * size;
        c.origin = center + normal() * height;
        return c;
    }

  private:
    void add_nested(SceneBuilder& b, int mesh, const glm::mat4& place) const {
        const int outer = b.place(kUnset, glm::scale(place, vec3(1000 * size)));
        const int inner = b.place(mesh, glm::scale(glm::mat4(1), vec3(0.1f)));
        Node& node = b.scene.nodes[std::size_t(inner)];
        node.parent = outer;
        for (const float below : {0.0f, 100.0f})
            node.instances.push_back(
                glm::translate(glm::scale(glm::mat4(1), vec3(0.01f)), -normal() * below));
    }
};

// Sunlight from an elevation above the floor, on the side of its x axis.
void add_sun(SceneBuilder& b, const Floor& floor, float elevation) {
    Light sun;
    sun.kind = kLightDirectional;
    sun.intensity = 4;
    const vec3 z = floor.normal() * std::sin(elevation) + floor.x() * std::cos(elevation);
    const vec3 x(0, 0, -1);
    b.light(sun, glm::mat4(vec4(x, 0), vec4(cross(z, x), 0), vec4(z, 0), vec4(0, 0, 0, 1)));
}

std::string describe(const Floor& f) {
    return "size " + std::to_string(f.size) + ", center " + std::to_string(f.center.x) + " " +
           std::to_string(f.center.y) + ", tilt " + std::to_string(f.tilt) + ", how " +
           std::to_string(int(f.how));
}

// Two sizes a decade from 1e-6 to 1e9, each at the origin, a few sizes away, and as far away as
// float precision still resolves 1/1000 of the size: so tests beyond 1e7 have floors of 2000 and
// more.
template <class F>
void for_all_floors(const F& check) {
    const bool thorough = test::backend().thorough;
    for (int power = -12; power <= 18; power += thorough ? 1 : 6)
        for (float away : {0.0f, 0.05f, 30.0f, 5000.0f})
            for (float tilt : {0.0f, 0.3f, -1.2f})
                for (How how :
                     {How::vertices, How::translated, How::scaled, How::instanced, How::nested}) {
                    const float size = std::pow(10.0f, 0.5f * float(power));
                    const bool skipped = tilt == 0 || (how != How::vertices && how != How::nested);
                    if (!thorough && skipped) continue;
                    check(Floor{size, vec3(0.7f, 1, -0.4f) * (away * size), tilt, how});
                }
}

// Sunlight arrives unshadowed, down to an elevation of three degrees.
TEST(Scale, AFloorUnderTheSunDoesNotShadowItself) {
    for_all_floors([](const Floor& floor) {
        for (float elevation : {1.5f, 0.3f, 0.05f}) {
            SceneBuilder b;
            floor.add(b);
            add_sun(b, floor, elevation);
            Studio studio(b.scene);
            const vec3 right = kAlbedo * (4 * std::sin(elevation) / std::numbers::pi_v<float>);
            for (const vec3& p :
                 studio.render(floor.camera(), {.samples = 4, .strategy = kStrategyBsdf}).pixels)
                ASSERT_LT(length(p - right), 1e-3f * length(right))
                    << describe(floor) << ", elevation " << elevation << ": " << p.x
                    << " instead of " << right.x;
        }
    });
}

// Under a uniform sky, every BSDF sample direction has the same radiance unless the floor occludes
// it.
TEST(Scale, AFloorUnderTheSkyDoesNotShadowItself) {
    for_all_floors([](const Floor& floor) {
        SceneBuilder b;
        floor.add(b);
        Studio studio(b.scene, test::constant_environment(vec3(1)));
        const Shot shot{.samples = 16, .strategy = kStrategyBsdf};
        for (const vec3& p : studio.render(floor.camera(), shot).pixels)
            ASSERT_LT(length(p - kAlbedo), 1e-3f * length(kAlbedo))
                << describe(floor) << ": " << p.x << " instead of " << kAlbedo.x;
    });
}

// A plate that floats 1/1000 of its size above the floor blocks all light below its middle, that of
// the sky and that of the sun down to three degrees.
TEST(Scale, AThinGapIsDark) {
    for_all_floors([](const Floor& floor) {
        if (floor.center.x > 1000 * floor.size) return;  // floats do not resolve the gap
        const float gap = 1e-3f * floor.size;
        Floor plate = floor;
        plate.center = floor.center + floor.normal() * gap;
        const CameraData camera = floor.camera_above(0.5f * gap);
        const auto expect_dark = [&](Studio& studio, const std::string& light) {
            const Shot shot{.samples = 8, .strategy = kStrategyBsdf};
            for (const vec3& p : studio.render(camera, shot).pixels)
                ASSERT_EQ(p.x, 0.0f) << describe(floor) << ", " << light;
        };
        SceneBuilder sky;
        floor.add(sky);
        plate.add(sky);
        Studio under_sky(sky.scene, test::constant_environment(vec3(1)));
        expect_dark(under_sky, "sky");
        for (float elevation : {1.5f, 0.3f, 0.05f}) {
            SceneBuilder b;
            floor.add(b);
            plate.add(b);
            add_sun(b, floor, elevation);
            Studio under_sun(b.scene);
            expect_dark(under_sun, "sun at " + std::to_string(elevation));
        }
    });
}

// A room's ceiling with a lamp `below` it, in units of the floor's size.
struct LampAtCeiling {
    Floor floor, ceiling;
    Light lamp;
    vec3 at;

    LampAtCeiling(const Floor& f, float below, std::uint32_t kind) : floor(f), ceiling(f) {
        ceiling.center = floor.center + floor.normal() * (0.5f * floor.size);
        lamp.kind = kind;
        lamp.intensity = floor.size * floor.size;
        lamp.inner_cone = lamp.outer_cone = 1.5f;
        at = vec3(glm::dvec3(ceiling.center) +
                  glm::dvec3(floor.x() * 0.137f - vec3(0, 0, 0.219f) - floor.normal() * below) *
                      double(floor.size));
    }

    // With the ceiling or without it.
    test::Picture render(const CameraData& camera, bool closed) const {
        SceneBuilder b;
        floor.add(b);
        if (closed) ceiling.add(b);
        // Shines along -z: a spot points to the floor.
        const vec3 z = floor.normal(), x(0, 0, -1);
        b.light(lamp, glm::mat4(vec4(x, 0), vec4(cross(z, x), 0), vec4(z, 0), vec4(at, 1)));
        return Studio(b.scene).render(
            camera, {.width = 16, .height = 16, .samples = 1, .strategy = kStrategyBsdf});
    }
};

// Lamps below and exactly in the plane of a ceiling light the floor as if it were not there; a
// thousandth of the size above it they do not shine through. 5000 sizes from the origin that is two
// units in the last place, which a lamp in the plane may be off by as well: three times that.
TEST(Scale, ALampNearTheCeilingLightsItsSide) {
    for_all_floors([](const Floor& floor) {
        if (floor.how == How::scaled || floor.how == How::instanced) return;  // as nested
        CameraData camera = floor.camera();
        camera.origin = floor.center + (camera.origin - floor.center) * 0.3f;
        for (const std::uint32_t kind : {kLightPoint, kLightSpot}) {
            if (!test::backend().thorough && kind == kLightSpot) continue;
            const test::Picture open = LampAtCeiling(floor, 0, kind).render(camera, false);
            for (const vec3& p : open.pixels)
                ASSERT_GT(p.x, 0);
            const test::Picture in_plane = LampAtCeiling(floor, 0, kind).render(camera, true);
            EXPECT_EQ(in_plane.pixels, open.pixels) << describe(floor) << ", in the plane";
            const float off = floor.center.x > 1000 * floor.size ? 3e-3f : 1e-3f;
            const LampAtCeiling below(floor, off, kind);
            EXPECT_EQ(below.render(camera, true).pixels, below.render(camera, false).pixels)
                << describe(floor);
            for (const vec3& p : LampAtCeiling(floor, -off, kind).render(camera, true).pixels)
                ASSERT_EQ(p.x, 0) << describe(floor);
        }
    });
}

// The same for a small plate below the ceiling that faces the lamp from the side: shadow rays that
// nearly graze the ceiling, down to 1/5 of a degree.
TEST(Scale, ALampInTheCeilingReachesAlongIt) {
    for_all_floors([](const Floor& ceiling) {
        if (ceiling.how == How::scaled || ceiling.how == How::instanced) return;
        for (const float below : {0.002f, 0.01f, 0.1f}) {
            if (!test::backend().thorough && below > 0.002f) continue;
            const vec3 at(glm::dvec3(ceiling.center) +
                          glm::dvec3(ceiling.x()) * (0.1 * double(ceiling.size)));
            const float half = 0.5f * below * ceiling.size;
            const vec3 middle = at - ceiling.x() * (0.5f * ceiling.size) -
                                ceiling.normal() * (below * ceiling.size);
            const auto render = [&](bool closed) {
                SceneBuilder b;
                b.place(b.quad(middle - ceiling.normal() * half - vec3(0, 0, half),
                               ceiling.normal() * (2 * half), vec3(0, 0, 2 * half),
                               b.material(test::lambertian(kAlbedo))));
                if (closed) ceiling.add(b);
                Light lamp;
                lamp.kind = kLightPoint;
                lamp.intensity = ceiling.size * ceiling.size;
                b.light(lamp, glm::translate(glm::mat4(1), at));
                CameraData camera =
                    camera_look_at(middle + ceiling.x() * half, middle, ceiling.normal(), 1, 1);
                camera.kind = kCameraOrthographic;
                camera.half_width = camera.half_height = 0.9f * half;
                return Studio(b.scene).render(camera, {.samples = 1, .strategy = kStrategyBsdf});
            };
            const test::Picture open = render(false);
            ASSERT_GT(open.mean().x, 0) << describe(ceiling);
            EXPECT_EQ(render(true).pixels, open.pixels) << describe(ceiling) << ", " << below;
        }
    });
}

// A small emitter far above a floor lights it by its area over the squared distance: the error of a
// hit on it grows with the ray's length, not with the emitter.
TEST(Scale, ASmallEmitterFarAwayIsSeen) {
    for_all_floors([](Floor floor) {
        if (floor.how == How::scaled || floor.how == How::instanced) return;  // as nested
        if (floor.center.x > 10 * floor.size) return;  // floats do not resolve the emitter
        const float height = 10 * floor.size;
        // The emitter is at the origin, where its own coordinates add no error.
        if (floor.center.x == 0) floor.center = floor.normal() * -height;
        for (const float half : {1e-2f, 1e-3f, 1e-4f}) {
            const float h = half * height;
            SceneBuilder b;
            floor.add(b);
            const vec3 z(0, 0, -1);
            const vec3 middle = floor.center + floor.normal() * height;
            b.place(b.quad(middle - floor.x() * h + z * h, floor.x() * (2 * h), z * (-2 * h),
                           b.material(test::emitter(vec3(1 / (half * half))))));
            Studio studio(b.scene);
            const Shot shot{.samples = 4, .strategy = kStrategyLight};
            const vec3 right = kAlbedo * (4 / std::numbers::pi_v<float>);
            // Half of the floor's view is 0.03 of the height: cos^4 is 1 to 2e-3.
            for (const vec3& p : studio.render(floor.camera_above(floor.size), shot).pixels)
                ASSERT_LT(length(p - right), 1e-2f * length(right))
                    << describe(floor) << ", emitter " << half << ": " << p.x << " instead of "
                    << right.x;
        }
    });
}

// A lamp above a floor with a box on it: there is no absolute length scale, so a scene that is 2^20
// times larger or smaller gives exactly the same image.
TEST(Scale, PowersOfTwoGiveTheSamePicture) {
    const auto render = [](float size) {
        SceneBuilder b;
        Floor{.size = size}.add(b);
        const glm::mat4 box = glm::translate(glm::mat4(1), vec3(0.2f, 0.1f, 0) * size);
        b.place(test::add_cube(b, false, b.material(test::lambertian(vec3(0.5f)))),
                glm::scale(box, vec3(0.1f * size)));
        b.place(b.quad(vec3(-0.2f, 1, -0.2f) * size, vec3(0.4f, 0, 0) * size,
                       vec3(0, 0, 0.4f) * size, b.material(test::emitter(vec3(3)))));
        Studio studio(b.scene);
        CameraData camera =
            camera_look_at(vec3(0.3f, 0.5f, 1) * size, vec3(0), vec3(0, 1, 0), 1, 1);
        return studio.render(
            camera,
            {.width = 16, .height = 16, .samples = 16, .bounces = 4, .strategy = kStrategyLight});
    };
    const test::Picture unit = render(1);
    EXPECT_GT(unit.mean().x, 0.01f);
    for (float size : {0x1p-20f, 0x1p20f}) {
        const test::Picture other = render(size);
        for (std::size_t i = 0; i < unit.pixels.size(); ++i)
            ASSERT_EQ(unit.pixels[i], other.pixels[i]) << "size " << size << ", pixel " << i;
    }
}

}  // namespace
}  // namespace hm
