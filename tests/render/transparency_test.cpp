// Alpha blend and mask against the product of the layers' transmittances.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/pictures.h"

namespace hm {
namespace {

using test::SceneBuilder;
using test::Shot;
using test::Studio;

const glm::mat4 kOne(1);

// n black layers of the given alpha above the floor, as one mesh or as one instance each.
SceneBuilder layers(int n, float alpha, bool instances) {
    SceneBuilder b;
    b.place(b.quad(vec3(-5, 0, 5), vec3(10, 0, 0), vec3(0, 0, -10),
                   b.material(test::lambertian(vec3(1)))));
    Material m = test::lambertian(vec3(0));
    m.alpha_mode = kAlphaBlend;
    m.base_color.w = alpha;
    m.double_sided = true;
    int material = b.material(m);
    std::vector<Primitive> all;
    int one = b.quad(vec3(-5, 2, 5), vec3(10, 0, 0), vec3(0, 0, -10), material);
    for (int i = 0; i < n; ++i) {
        if (instances)
            b.place(one, glm::translate(kOne, vec3(0, 0.1f * float(i), 0)));
        else
            all.push_back(b.quad_primitive(vec3(-5, 2 + 0.1f * float(i), 5), vec3(10, 0, 0),
                                           vec3(0, 0, -10), material));
    }
    if (!instances && n > 0) b.place(b.mesh(all));
    return b;
}

TEST(Transparency, LayersMultiplyForTheCamera) {
    const float alpha = 0.3f;
    for (bool instances : {false, true})
        for (int n : {0, 1, 2, 5}) {
            SceneBuilder b = layers(n, alpha, instances);
            b.scene.nodes.erase(b.scene.nodes.begin());  // no floor: straight into the sky
            Studio studio(b.scene, test::constant_environment(vec3(1, 2, 4)));
            CameraData camera = test::flat_camera(vec3(0, 5, 0), vec3(0.2f, 1, 0.1f), 0.5f);
            SCOPED_TRACE(testing::Message() << n << " layers, instances " << instances);
            test::expect_radiance(studio, camera, {.samples = 256},
                                  vec3(1, 2, 4) * float(std::pow(1 - alpha, n)));
        }
}

TEST(Transparency, LayersMultiplyForShadowRays) {
    const float alpha = 0.4f;
    for (bool instances : {false, true})
        for (int n : {1, 3}) {
            SceneBuilder b = layers(n, alpha, instances);
            Light sun;
            sun.kind = kLightDirectional;
            sun.intensity = std::numbers::pi_v<float>;
            b.light(sun, glm::rotate(kOne, -std::numbers::pi_v<float> / 2, vec3(1, 0, 0)));
            Studio studio(b.scene);
            CameraData camera = test::point_camera(vec3(0.3f, 0, 0.2f), vec3(1, 0.5f, 0));
            SCOPED_TRACE(testing::Message() << n << " layers, instances " << instances);
            test::expect_radiance(studio, camera, {.samples = 512},
                                  vec3(float(std::pow(1 - alpha, n))));
        }
}

TEST(Transparency, EveryRayDrawsItsOwnChance) {
    // Light passes a layer going down and again going up: two independent random decisions.
    const float alpha = 0.5f;
    SceneBuilder b = layers(1, alpha, false);
    Light sun;
    sun.kind = kLightDirectional;
    sun.intensity = std::numbers::pi_v<float>;
    b.light(sun, glm::rotate(kOne, -std::numbers::pi_v<float> / 2, vec3(1, 0, 0)));
    Studio studio(b.scene);
    // Away from the quad's diagonal, where a ray may hit both triangles.
    const vec3 point(0.3f, 0, 0.2f), from(0.2f, 1, 0.1f);
    CameraData camera = test::point_camera(point, from);
    camera.origin = point + from * 5.0f;
    test::expect_radiance(studio, camera, {.samples = 512}, vec3((1 - alpha) * (1 - alpha)));
}

// The samplers that are sequences.
constexpr uint kSequences[] = {kSamplerSobolOwen, kSamplerSobolBlueNoise};

TEST(Transparency, SequencesAreUnbiased) {
    const float alpha = 0.3f;
    for (uint sampler : kSequences)
        for (int n : {1, 2, 5}) {
            SceneBuilder b = layers(n, alpha, false);
            b.scene.nodes.erase(b.scene.nodes.begin());
            Studio studio(b.scene, test::constant_environment(vec3(1, 2, 4)));
            CameraData camera = test::flat_camera(vec3(0, 5, 0), vec3(0.2f, 1, 0.1f), 0.5f);
            SCOPED_TRACE(testing::Message() << n << " layers, sampler " << sampler);
            test::expect_radiance(studio, camera, {.samples = 24, .sampler = sampler},
                                  vec3(1, 2, 4) * float(std::pow(1 - alpha, n)), 0.02);
        }
}

// In each aligned block of 64 samples, exactly one random number falls into each 64th of [0, 1).
// The image shows only one triangle.
TEST(Transparency, AlphaIsStratifiedOverTheSamples) {
    const float alpha = 0.3f;
    SceneBuilder b = layers(1, alpha, false);
    b.scene.nodes.erase(b.scene.nodes.begin());
    Studio studio(b.scene);
    CameraData camera = test::flat_camera(vec3(1.5f, 2, 1), vec3(0, 1, 0), 0.5f);
    for (uint sampler : kSequences)
        for (uint first : {0u, 192u}) {
            const Shot shot{.samples = 64,
                            .first_sample = first,
                            .sampler = sampler,
                            .background = kBackgroundTransparent};
            for (float a : studio.render(camera, shot).alpha)
                EXPECT_NEAR(a, alpha, 1.0f / 64 + 1e-5f) << sampler << " from " << first;
        }
}

// If layers of alpha 0.5 shared the leading bit of their random numbers, each pixel would transmit
// none or half of the light, for any number of samples.
TEST(Transparency, StratifiedLayersAreIndependent) {
    SceneBuilder b = layers(2, 0.5f, false);
    b.scene.nodes.erase(b.scene.nodes.begin());
    Studio studio(b.scene);
    CameraData camera = test::flat_camera(vec3(1.5f, 2, 1), vec3(0, 1, 0), 0.5f);
    const uint samples = 4096;
    for (uint sampler : kSequences) {
        const Shot shot{
            .samples = samples, .sampler = sampler, .background = kBackgroundTransparent};
        // Six standard deviations of this many independent samples, for 64 pixels.
        for (float a : studio.render(camera, shot).alpha)
            EXPECT_NEAR(a, 0.75, 6 * std::sqrt(0.25 * 0.75 / samples)) << sampler;
    }
}

TEST(Transparency, CoverageIsAlphaOfATransparentPicture) {
    SceneBuilder b = layers(1, 0.25f, false);
    b.scene.nodes.erase(b.scene.nodes.begin());
    Studio studio(b.scene);
    Shot shot{.samples = 1024, .background = kBackgroundTransparent};
    CameraData camera = test::flat_camera(vec3(0, 2, 0), vec3(0, 1, 0), 0.5f);
    double alpha = 0;
    for (float a : studio.render(camera, shot).alpha)
        alpha += double(a) / 64;
    // 65536 samples with probability 0.25: five standard deviations.
    EXPECT_NEAR(alpha, 0.25, 5 * std::sqrt(0.25 * 0.75 / 65536));
}

TEST(Transparency, MasksCutByFactorTextureAndVertexColour) {
    // alpha = factor * texel * vertex colour, compared with the cutoff of 0.5.
    struct Case {
        float factor, texel, color;
        bool solid;
    };
    for (Case c :
         {Case{0.9f, 1, 0.7f, true}, Case{0.9f, 0.5f, 1, false}, Case{0.9f, 0.8f, 0.5f, false},
          Case{0.4f, 1, 1, false}, Case{0.8f, 0.8f, 0.8f, true}}) {
        SceneBuilder b;
        Material m = test::lambertian(vec3(1));
        m.alpha_mode = kAlphaMask;
        m.base_color.w = c.factor;
        m.base_color_texture.image = b.image(1, 1, {vec4(1, 1, 1, c.texel)});
        m.double_sided = true;
        int mesh = b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), b.material(m));
        Primitive& p = b.scene.meshes[std::size_t(mesh)].primitives[0];
        p.extras.assign(4, {vec2(0), vec4(1, 1, 1, c.color)});
        b.place(mesh);
        Studio studio(b.scene);
        Shot shot{.samples = 2, .background = kBackgroundTransparent};
        test::Picture picture =
            studio.render(test::flat_camera(vec3(0), vec3(0, 0, 1), 0.5f), shot);
        for (float a : picture.alpha)
            EXPECT_EQ(a, c.solid ? 1.0f : 0.0f) << c.factor << " " << c.texel << " " << c.color;
    }
}

TEST(Transparency, CamerasSeeThroughSingleSidedBacks) {
    for (bool two_sided : {false, true}) {
        SceneBuilder b;
        Material m = test::lambertian(vec3(0));
        m.double_sided = two_sided;
        // Faces +z and is seen from behind, against a white sky.
        b.place(b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), b.material(m)));
        Studio studio(b.scene, test::constant_environment(vec3(1)));
        CameraData camera = test::flat_camera(vec3(0), vec3(0, 0, -1), 0.5f);
        for (const vec3& p : studio.render(camera, {.samples = 2}).pixels)
            EXPECT_NEAR(p.x, two_sided ? 0.0f : 1.0f, 1e-6f);
    }
}

}  // namespace
}  // namespace hm
