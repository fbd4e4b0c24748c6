// Glass and the media in it, in full renderings against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/pictures.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Shot;
using test::Studio;

constexpr double kIor = 1.5;

Material glass(float ior, float thickness) {
    Material m;
    m.metallic = 0;
    m.roughness = 0;
    m.transmission = 1;
    m.ior = ior;
    m.thickness = thickness;
    return m;
}

// White above the plane y = 0, black below; and the other way round.
EnvironmentMap half_sky(bool upper) {
    std::vector<vec3> texels(2 * 64, vec3(0));
    for (std::size_t row = 0; row < 64; ++row)
        for (std::size_t k = 0; k < 2; ++k)
            if ((row < 32) == upper) texels[2 * row + k] = vec3(1);
    return make_environment(test::environment_image(2, 64, texels), 0, 1);
}

// A box that is wide enough for no path to meet its sides, of this thickness along y.
void add_slab(SceneBuilder& b, int material, float thickness, float y = 0) {
    const int cube = test::add_cube(b, false, material);
    b.place(cube, glm::translate(glm::mat4(1), vec3(0, y, 0)) *
                      glm::scale(glm::mat4(1), vec3(50, thickness / 2, 50)));
}

vec3 view_at(double cosine) {
    return {float(std::sqrt(1 - cosine * cosine)), float(cosine), 0};
}

double fresnel(double cos_i, double eta) {
    const double sin_t = std::sqrt(1 - cos_i * cos_i) / eta, cos_t = std::sqrt(1 - sin_t * sin_t);
    const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const double p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return (s * s + p * p) / 2;
}

constexpr Shot kDeep{.width = 4, .height = 4, .samples = 2048, .bounces = 0};

// With all reflections inside: R = r + r (1 - r)^2 a^2 / (1 - r^2 a^2), T = (1 - r)^2 a / (1 - r^2
// a^2), where a is what one crossing leaves (Born and Wolf, 7.6, incoherent).
TEST(Glass, SlabReflectsAndTransmitsWithAllReflectionsInside) {
    for (const double cosine : {1.0, 0.6, 0.2}) {
        SceneBuilder b;
        Material m = glass(float(kIor), 1);
        m.attenuation_distance = 0.5f;
        m.attenuation_color = {0.9f, 0.5f, 0.2f};
        add_slab(b, b.material(m), 0.3f);
        const CameraData camera = test::point_camera(vec3(0, 0.15f, 0), view_at(cosine));
        const double r = fresnel(cosine, kIor);
        const double path = 0.3 / std::sqrt(1 - (1 - cosine * cosine) / (kIor * kIor));
        vec3 reflected, transmitted;
        for (int k = 0; k < 3; ++k) {
            const double a = std::pow(double(m.attenuation_color[k]), path / 0.5);
            reflected[k] = float(r + r * (1 - r) * (1 - r) * a * a / (1 - r * r * a * a));
            transmitted[k] = float((1 - r) * (1 - r) * a / (1 - r * r * a * a));
        }
        Studio above(b.scene, half_sky(true)), below(b.scene, half_sky(false));
        test::expect_radiance(above, camera, kDeep, reflected, 8e-3);
        test::expect_radiance(below, camera, kDeep, transmitted, 4e-3);
    }
}

TEST(Glass, ThinWallsDoNotBendOrAbsorb) {
    SceneBuilder b;
    Material m = glass(float(kIor), 0);
    m.attenuation_distance = 0.01f;
    m.attenuation_color = vec3(0.1f);
    m.base_color = vec4(0.8f, 0.5f, 0.2f, 1);
    m.double_sided = true;
    b.place(b.quad(vec3(-100, 0, 100), vec3(200, 0, 0), vec3(0, 0, -200), b.material(m)));
    const double cosine = 0.5, r = fresnel(cosine, kIor);
    Studio below(b.scene, half_sky(false));
    test::expect_radiance(below, test::point_camera(vec3(0), view_at(cosine)), kDeep,
                          vec3(m.base_color) * float(1 - r), 1e-3);
}

// A black slab with a white hole under a glass plate: the hole is seen where Snell's law puts it.
TEST(Glass, RefractionFollowsSnellForEveryColour) {
    const float dispersion = 20 / 30.0f;  // Abbe number 30
    const double cosine = 0.4, depth = 2;
    for (int channel = 0; channel < 3; ++channel) {
        const double ior = kIor + (channel - 1) * (kIor - 1) * 0.025 * double(dispersion);
        const double sin_t = std::sqrt(1 - cosine * cosine) / ior;
        const double gap = 1e-3, slope = std::sqrt(1 - cosine * cosine) / cosine;
        const double reach = depth * sin_t / std::sqrt(1 - sin_t * sin_t) + gap * slope;
        SceneBuilder b;
        Material m = glass(float(kIor), 1);
        m.dispersion = dispersion;
        add_slab(b, b.material(m), float(depth), -float(depth) / 2);
        // Narrower than the distance of two channels' places, 0.02.
        const float half = 0.004f;
        b.place(b.quad(vec3(-float(reach) - half, -float(depth + gap), 1), vec3(2 * half, 0, 0),
                       vec3(0, 0, -2), b.material(test::emitter(vec3(1)))));
        Studio studio(b.scene);
        const vec3 seen = studio.render(test::point_camera(vec3(0), view_at(cosine)), kDeep).mean();
        const double r = fresnel(cosine, ior);
        for (int k = 0; k < 3; ++k) {
            const double exact = k == channel ? (1 - r) * (1 - r) / (1 - r * r) : 0;
            EXPECT_NEAR(double(seen[k]), exact, 0.1) << "channel " << channel << ", seen in " << k;
        }
    }
}

// Under a constant sky, clear glass of any shape and roughness is invisible.
TEST(Glass, ClearGlassIsInvisibleInAWhiteFurnace) {
    for (const float roughness : {0.0f, 0.3f, 0.8f}) {
        SceneBuilder b;
        Material m = glass(1.5f, 1);
        m.roughness = roughness;
        b.place(b.sphere(32, b.material(m)));
        Studio studio(b.scene, test::constant_environment(vec3(1)));
        Shot shot = kDeep;
        shot.samples = 512;
        // The table's interpolation, at every crossing.
        test::expect_radiance(studio, test::flat_camera(vec3(0), vec3(0, 0, 1), 0.5f), shot,
                              vec3(1), roughness > 0 ? 0.03 : 1e-3);
    }
}

// Dispersion draws one channel of three: grey stays grey in the mean.
TEST(Glass, DispersionKeepsGrey) {
    SceneBuilder b;
    Material m = glass(1.5f, 1);
    m.dispersion = 3;
    b.place(b.sphere(32, b.material(m)));
    Studio studio(b.scene, test::constant_environment(vec3(0.5f)));
    test::expect_radiance(studio, test::flat_camera(vec3(0), vec3(0, 0, 1), 0.5f), kDeep,
                          vec3(0.5f), 5e-3);
}

// Water whose mesh reaches into the glass below it: one boundary from water to glass, whose
// reflectance is that of their indices; the glass's upper face inside the water is none.
TEST(Glass, WaterThatReachesIntoGlassHasOneBoundary) {
    SceneBuilder b;
    add_slab(b, b.material(glass(1.5f, 1)), 1, -0.5f);     // y from -1 to 0
    add_slab(b, b.material(glass(1.33f, 1)), 0.6f, 0.2f);  // y from -0.1 to 0.5
    // From air through water into glass and out below, all reflections summed by transfer of
    // intensities from the last boundary up.
    const double outer = fresnel(1, 1.33), middle = fresnel(1, 1.5 / 1.33),
                 lower = fresnel(1, 1 / 1.5);
    double reflected = lower;
    for (const double r : {middle, outer})
        reflected = r + (1 - r) * (1 - r) * reflected / (1 - r * reflected);
    Studio above(b.scene, half_sky(true)), below(b.scene, half_sky(false));
    const CameraData camera = test::point_camera(vec3(0, 0.5f, 0), vec3(0, 1, 0));
    test::expect_radiance(above, camera, kDeep, vec3(float(reflected)), 6e-3);
    test::expect_radiance(below, camera, kDeep, vec3(float(1 - reflected)), 1e-3);
}

// The medium that the camera is in absorbs, though no ray entered it.
TEST(Glass, ACameraInsideAVolumeSeesThroughIt) {
    SceneBuilder b;
    Material m = glass(1, 1);
    m.attenuation_distance = 2;
    m.attenuation_color = {0.5f, 0.25f, 0.9f};
    b.place(test::add_cube(b, false, b.material(m)));
    Studio studio(b.scene, test::constant_environment(vec3(1)));
    CameraData camera = test::flat_camera(vec3(0), vec3(0, 0, 1), 0.1f);
    camera.origin = vec3(0);
    vec3 exact;
    for (int k = 0; k < 3; ++k)
        exact[k] = std::sqrt(m.attenuation_color[k]);  // one metre of two
    test::expect_radiance(studio, camera, kDeep, exact, 1e-4);
}

// A sheet that lets all light through diffusely, lit from behind: half the sky's radiance on either
// side becomes the mean of both.
TEST(Glass, DiffuseTransmissionMixesBothSides) {
    SceneBuilder b;
    Material m = test::lambertian(vec3(0.6f));
    m.diffuse_transmission = 0.25f;
    m.diffuse_transmission_color = {1, 0.5f, 0.2f};
    m.double_sided = true;
    b.place(b.quad(vec3(-1, 0, 1), vec3(2, 0, 0), vec3(0, 0, -2), b.material(m)));
    Studio above(b.scene, half_sky(true)), below(b.scene, half_sky(false));
    const CameraData camera = test::point_camera(vec3(0), view_at(0.7));
    test::expect_radiance(above, camera, kDeep, vec3(0.6f * 0.75f), 4e-3);
    test::expect_radiance(below, camera, kDeep, m.diffuse_transmission_color * 0.25f, 4e-3);
}

}  // namespace
}  // namespace hm
