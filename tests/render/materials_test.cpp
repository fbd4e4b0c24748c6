// Normals, normal maps, mirrored instances and white materials (white furnace) in full renderings.
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

const glm::mat4 kOne(1);
constexpr float kPiFloat = std::numbers::pi_v<float>;

Light sun_light() {
    Light sun;
    sun.kind = kLightDirectional;
    sun.intensity = kPiFloat;  // so that Lambertian radiance is albedo times cosine
    return sun;
}

// A sun that shines along -towards.
void add_sun(SceneBuilder& b, vec3 towards) {
    vec3 z = normalize(towards);
    vec3 x = normalize(cross(std::abs(z.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0), z));
    b.light(sun_light(), glm::mat4(vec4(x, 0), vec4(cross(z, x), 0), vec4(z, 0), vec4(0, 0, 0, 1)));
}

vec3 look_at(SceneBuilder& b, vec3 point, vec3 from) {
    Studio studio(b.scene);
    return studio.render(test::point_camera(point, from), {.width = 2, .height = 2, .samples = 4})
        .mean();
}

TEST(Materials, WithoutNormalsASurfaceIsFlat) {
    const vec3 tilted = normalize(vec3(0.3f, 0.2f, 1)), sun = normalize(vec3(0.5f, -0.1f, 1));
    for (bool has_normals : {false, true}) {
        SceneBuilder b;
        int mesh = b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0),
                          b.material(test::lambertian(vec3(1))));
        Primitive& p = b.scene.meshes[std::size_t(mesh)].primitives[0];
        for (Vertex& v : p.vertices)
            v.normal = tilted;
        p.has_normals = has_normals;
        b.place(mesh);
        add_sun(b, sun);
        float expected = dot(sun, has_normals ? tilted : vec3(0, 0, 1));
        EXPECT_NEAR(look_at(b, vec3(0.1f, 0.2f, 0), vec3(0.1f, 0, 1)).x, expected, 1e-5f);
    }
}

TEST(Materials, NormalMapsLeanRightAndUp) {
    // One texel whose normal leans to the image's right and top. In an upright image v increases
    // downwards; the tangent space must be the same with and without tangents in the file, and must
    // follow a texture that is upside down or mirrored.
    const vec3 texel(0.7f, 0.65f, 0.9f);
    const vec3 sun = normalize(vec3(0.3f, 0.5f, 1));
    for (float turn_u : {1.0f, -1.0f})
        for (float turn_v : {1.0f, -1.0f})
            for (bool tangents : {false, true})
                for (uint uv_set : {0u, 1u}) {
                    SceneBuilder b;
                    Material m = test::lambertian(vec3(1));
                    m.normal_texture.image = b.image(1, 1, {vec4(texel, 1)});
                    m.normal_texture.uv_set = uv_set;
                    int mesh = b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), b.material(m));
                    Primitive& p = b.scene.meshes[std::size_t(mesh)].primitives[0];
                    for (Vertex& v : p.vertices) {
                        vec2 uv(v.position.x * turn_u, -v.position.y * turn_v);
                        v.uv0 = uv_set == 0 ? uv : vec2(v.position.y, v.position.x);
                        v.tangent = vec4(turn_u, 0, 0, turn_u * turn_v);
                        if (uv_set == 1) p.extras.push_back({uv, vec4(1)});
                    }
                    p.has_tangents = tangents;
                    b.place(mesh);
                    add_sun(b, sun);
                    float x = 2 * std::round(texel.x * 255) / 255 - 1;
                    float y = 2 * std::round(texel.y * 255) / 255 - 1;
                    float z = 2 * std::round(texel.z * 255) / 255 - 1;
                    vec3 n = normalize(vec3(x * turn_u, y * turn_v, z));
                    EXPECT_NEAR(look_at(b, vec3(0.1f, 0.2f, 0), vec3(0, 0, 1)).x, dot(n, sun),
                                1e-5f)
                        << "u " << turn_u << ", v " << turn_v << ", tangents " << tangents
                        << ", uv set " << uv_set;
                }
}

// All three channels count: (1, 0, 1) / sqrt 2 stored short of unit length leans by 45 degrees.
TEST(Materials, NormalMapsAreNormalizedNotRebuilt) {
    const vec3 sun = normalize(vec3(1, 0, 1));
    for (const float length : {0.5f, 0.7f}) {
        SceneBuilder b;
        Material m = test::lambertian(vec3(1));
        const float half = 0.5f + 0.5f * length;
        m.normal_texture.image = b.image(1, 1, {vec4(half, 0.5f, half, 1)});
        b.place(b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), b.material(m)));
        add_sun(b, sun);
        const vec3 n = normalize(2.0f * round(vec3(half, 0.5f, half) * 255.0f) / 255.0f - 1.0f);
        EXPECT_NEAR(std::acos(n.z), kPiFloat / 4, 1e-3f);
        EXPECT_NEAR(look_at(b, vec3(0.1f, 0.2f, 0), vec3(0, 0, 1)).x, dot(n, sun), 1e-5f);
    }
}

// Turned by a right angle or mirrored by KHR_texture_transform, the relief turns with the picture.
TEST(Materials, NormalMapsFollowTheTextureTransform) {
    const vec3 texel(0.7f, 0.65f, 0.9f), sun = normalize(vec3(0.3f, 0.5f, 1));
    const vec3 stored = 2.0f * round(texel * 255.0f) / 255.0f - 1.0f;
    struct Case {
        vec3 row_u, row_v;
        vec3 normal;  // in the quad's plane, where u runs along x and v along -y
    };
    const Case cases[] = {
        {{1, 0, 0.3f}, {0, 1, 0.2f}, {stored.x, stored.y, stored.z}},
        {{-2, 0, 0}, {0, 1, 0}, {-stored.x, stored.y, stored.z}},
        {{1, 0, 0}, {0, -1, 0}, {stored.x, -stored.y, stored.z}},
        {{0, 1, 0}, {-1, 0, 0}, {stored.y, -stored.x, stored.z}},
    };
    for (const Case& c : cases) {
        SceneBuilder b;
        Material m = test::lambertian(vec3(1));
        m.normal_texture.image = b.image(1, 1, {vec4(texel, 1)});
        m.normal_texture.uv_row_u = c.row_u;
        m.normal_texture.uv_row_v = c.row_v;
        const int mesh = b.quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), b.material(m));
        for (Vertex& v : b.scene.meshes[std::size_t(mesh)].primitives[0].vertices)
            v.uv0 = vec2(v.position.x, -v.position.y);
        b.place(mesh);
        add_sun(b, sun);
        EXPECT_NEAR(look_at(b, vec3(0.1f, 0.2f, 0), vec3(0, 0, 1)).x, dot(normalize(c.normal), sun),
                    1e-5f)
            << c.row_u.x << " " << c.row_u.y;
    }
}

// A bumpy, asymmetric shell lit from one side; optionally mirrored by its vertices.
SceneBuilder bumpy_shell(bool mirrored_vertices) {
    SceneBuilder b;
    Material m = test::lambertian(vec3(0.9f, 0.6f, 0.3f));
    m.specular_weight = 1;
    m.roughness = 0.4f;
    std::vector<vec4> texels;
    test::Random random(5);
    for (int i = 0; i < 64; ++i)
        texels.push_back(vec4(random.between(0.3f, 0.7f), random.between(0.3f, 0.7f), 1, 1));
    m.normal_texture.image = b.image(8, 8, texels);
    m.emissive_factor = vec3(0.01f);
    int mesh = b.sphere(24, b.material(m));
    Primitive& p = b.scene.meshes[std::size_t(mesh)].primitives[0];
    p.triangles.resize(p.triangles.size() * 3 / 4);
    if (mirrored_vertices) {
        for (Vertex& v : p.vertices) {
            v.position.x = -v.position.x;
            v.normal.x = -v.normal.x;
        }
        for (uvec3& t : p.triangles)
            std::swap(t.y, t.z);
    }
    return b;
}

TEST(Materials, MirroredInstancesLookLikeMirroredMeshes) {
    for (bool other_instances : {false, true}) {
        test::Picture pictures[2];
        for (bool by_vertices : {false, true}) {
            SceneBuilder b = bumpy_shell(by_vertices);
            b.place(0, by_vertices ? kOne : glm::scale(kOne, vec3(-1, 1, 1)));
            // With a second instance, the BVH keeps the mesh in object space.
            if (other_instances) b.place(0, glm::translate(kOne, vec3(0, 50, 0)));
            add_sun(b, vec3(0.6f, 0.5f, 0.7f));
            Studio studio(b.scene, {}, {.emitters = false});
            CameraData camera = test::flat_camera(vec3(0), vec3(0.2f, 0.1f, 1), 1.2f);
            camera.origin = camera.origin * 3.0f;
            Shot shot{.width = 48, .height = 48, .samples = 4};
            pictures[by_vertices ? 1 : 0] = studio.render(camera, shot);
        }
        int different = 0;
        for (std::size_t i = 0; i < pictures[0].pixels.size(); ++i) {
            vec3 d = pictures[0].pixels[i] - pictures[1].pixels[i];
            different += length(d) > 1e-3f * (1 + length(pictures[1].pixels[i])) ? 1 : 0;
        }
        // Samples exactly on a triangle edge may hit either side.
        EXPECT_LE(different, 2);
        EXPECT_GT(pictures[0].mean().x, 0.05f);
    }
}

// White furnace: a sphere of one material under a white sky.
Studio white_sphere(const Material& m, int segments, SceneBuilder& b) {
    b.place(b.sphere(segments, b.material(m)));
    return Studio(b.scene, test::constant_environment(vec3(1)));
}

Material white(float metallic, float roughness) {
    Material m;
    m.metallic = metallic;
    m.roughness = roughness;
    return m;
}

TEST(Materials, WhiteSpheresVanishInAWhiteSky) {
    for (float metallic : {0.0f, 1.0f})
        for (float roughness : {0.3f, 0.6f, 1.0f}) {
            SCOPED_TRACE(testing::Message() << "metallic " << metallic << " rough " << roughness);
            SceneBuilder b;
            Studio studio = white_sphere(white(metallic, roughness), 128, b);
            CameraData camera = test::flat_camera(vec3(0), vec3(1, 2, 3), 1.1f);
            camera.origin = camera.origin * 3.0f;
            Shot shot{.width = 16, .height = 16, .samples = 256, .bounces = 0};
            std::vector<vec3> means;
            std::vector<test::Picture> replicates = test::replicate(studio, camera, shot, 16, 1);
            for (const test::Picture& p : replicates)
                means.push_back(p.mean());
            // Table interpolation is accurate to 1 %; facets with smooth normals lose a little.
            test::Estimate e = test::estimate(means);
            EXPECT_NEAR(e.mean.x, 1.0f, 0.005f + 6 * e.error.x);
            EXPECT_LT(e.error.x, 1e-3f);
            for (std::size_t i = 0; i < 256; ++i) {
                std::vector<vec3> pixel;
                for (const test::Picture& p : replicates)
                    pixel.push_back(p.pixels[i]);
                test::Estimate at = test::estimate(pixel);
                EXPECT_NEAR(at.mean.x, 1.0f, 0.02f + 8 * at.error.x) << i;
            }
        }
}

TEST(Materials, NormalMapsLoseLittleInAWhiteSky) {
    // Light reflected below the geometric surface is lost: bumps of up to 25 degrees darken by a
    // few percent, and never brighten.
    SceneBuilder b;
    Material m = white(1, 0.5f);
    std::vector<vec4> texels;
    test::Random random(6);
    for (int i = 0; i < 1024; ++i)
        texels.push_back(vec4(random.between(0.3f, 0.7f), random.between(0.3f, 0.7f), 1, 1));
    m.normal_texture.image = b.image(32, 32, texels);
    Studio studio = white_sphere(m, 64, b);
    CameraData camera = test::flat_camera(vec3(0), vec3(1, 2, 3), 0.9f);
    camera.origin = camera.origin * 3.0f;
    Shot shot{.width = 16, .height = 16, .samples = 256, .bounces = 0};
    float mean = studio.render(camera, shot).mean().x;
    RecordProperty("mean", std::to_string(mean));
    EXPECT_GT(mean, 0.9f);
    EXPECT_LT(mean, 1.005f);
}

}  // namespace
}  // namespace hm
