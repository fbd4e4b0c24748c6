// Paving, parapet, pebbles and grass of the hero scene, and the landscape beyond.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "hero_objects.h"
#include "hero_terrain.h"
#include "noise.h"

namespace hm {
namespace {

constexpr float kWallZ = -2.45f;
constexpr float kHalfLength = 7;

// A river stone: a sphere squeezed and dented by noise.
TriangleMesh make_pebble(std::uint32_t seed) {
    TriangleMesh mesh = make_surface(28, 16, [seed](float s, float t) {
        const float azimuth = 6.2831853f * s, polar = 3.1415927f * (0.001f + 0.998f * t);
        const glm::vec3 d(std::sin(polar) * std::sin(azimuth), -std::cos(polar),
                          std::sin(polar) * std::cos(azimuth));
        const float dent =
            0.12f * gradient_noise({1.3f * d.x + 2 * d.y, 1.3f * d.z - d.y}, 0, seed) +
            0.06f * gradient_noise({3 * d.x - d.z, 3 * d.y + d.z}, 0, seed + 1);
        return SurfacePoint{d * glm::vec3(1, 0.62f, 0.8f) * (1 + dent), {2 * s, -t}};
    });
    return mesh;
}

// Blades of grass from a common root.
TriangleMesh make_tuft(std::uint32_t seed) {
    TriangleMesh tuft;
    for (std::uint32_t i = 0; i < 22; ++i) {
        const float angle = 6.2831853f * hash_unit(i, 0, seed),
                    lean = 0.02f + 0.11f * hash_unit(i, 1, seed);
        const float height = 0.09f + 0.13f * hash_unit(i, 2, seed),
                    root = 0.03f * hash_unit(i, 3, seed);
        const glm::vec3 out(std::cos(angle), 0, std::sin(angle)), side(-out.z, 0, out.x);
        TriangleMesh blade = make_surface(1, 5, [&](float s, float t) {
            const float width = 0.0035f * (1 - 0.92f * t);
            return SurfacePoint{out * (root + lean * t * t) +
                                    glm::vec3(0, height * t * (1 - 0.25f * t), 0) +
                                    side * width * (2 * s - 1),
                                {s, 1 - t}};
        });
        append(tuft, blade, glm::mat4(1));
    }
    return tuft;
}

// A fir of stacked cones with ragged edges.
TriangleMesh make_conifer() {
    TriangleMesh tree;
    constexpr int kSkirts = 7;
    for (int k = 0; k < kSkirts; ++k) {
        const float low = 1.2f + 1.35f * float(k), top = low + 2.6f;
        const float radius = 2.1f * (1 - float(k) / (kSkirts + 0.6f));
        TriangleMesh skirt = make_surface(14, 1, [&](float s, float t) {
            const float angle = 6.2831853f * s;
            const auto lobe = std::uint32_t(std::lround(s * 14)) % 14;
            const float ragged = 0.72f + 0.5f * hash_unit(lobe, std::uint32_t(k), 500);
            const float r = glm::mix(radius * ragged, 0.06f, t);
            return SurfacePoint{
                {r * std::sin(angle), glm::mix(low - 0.35f * ragged, top, t), r * std::cos(angle)},
                {s, t}};
        });
        append(tree, skirt, glm::mat4(1));
    }
    return tree;
}

// A vertical sheet of mist across the valley. It faces the camera, so that the sun lights its front
// everywhere; its normals are tilted up and towards the sun to look like a lit volume.
TriangleMesh make_mist(float distance, float low, float high) {
    const float half_width = 0.8f * distance;
    TriangleMesh mesh = make_surface(1, 1, [=](float s, float t) {
        const float u = 1.5f * s + 0.37f * distance / 300;
        return SurfacePoint{{half_width * (2 * s - 1), glm::mix(low, high, t), -distance},
                            {u, 0.995f - 0.99f * t}};
    });
    for (glm::vec3& normal : mesh.normals)
        normal = glm::normalize(glm::vec3(-0.7f, 1.2f, 1));
    return mesh;
}

}  // namespace

int HeroBuilder::single_mesh(const std::string& name, const TriangleMesh& mesh, int material) {
    const GltfPrimitive primitive = writer_.add_primitive(mesh, material);
    return writer_.add_mesh(name, {&primitive, 1});
}

void HeroBuilder::place(const std::string& name, int mesh, glm::vec3 position, float yaw,
                        glm::vec3 scale) {
    writer_.add_node({.name = name,
                      .translation = position,
                      .rotation = glm::angleAxis(yaw, glm::vec3(0, 1, 0)),
                      .scale = scale,
                      .mesh = mesh});
}

void HeroBuilder::add_terrace() {
    constexpr float kSlabRepeat = 2.4f, kFront = 8;
    const float depth = kFront - kWallZ;
    writer_.add_object("paving",
                       make_quad({-kHalfLength, 0, kFront}, {2 * kHalfLength, 0, 0}, {0, 0, -depth},
                                 {2 * kHalfLength / kSlabRepeat, depth / kSlabRepeat}),
                       materials_.slab);
    add_parapet();
    add_pebbles();
    add_grass();
}

void HeroBuilder::add_parapet() {
    const glm::vec3 half(0.21f, 0.083f, 0.18f), cap_half(0.36f, 0.04f, 0.24f);
    const TriangleMesh brick = make_rounded_box(half, 0.025f, 1.3f);
    const GltfPrimitive plain = writer_.add_primitive(brick, materials_.stone);
    const GltfPrimitive warm{plain.geometry, materials_.warm_stone};
    const int bricks[2] = {writer_.add_mesh("brick", {&plain, 1}),
                           writer_.add_mesh("warm brick", {&warm, 1})};
    const int cap =
        single_mesh("cap stone", make_rounded_box(cap_half, 0.018f, 1.1f), materials_.stone);
    constexpr float kLength = 0.43f, kCourse = 0.17f;
    for (std::uint32_t row = 0; row < 3; ++row)
        for (std::uint32_t i = 0; i < std::uint32_t(2 * kHalfLength / kLength); ++i) {
            const auto random = [&](std::uint32_t what) {
                return hash_unit(i, row * 8 + what, 600);
            };
            const float x = -kHalfLength + kLength * (float(i) + (row % 2 ? 0.5f : 0.0f));
            const glm::vec3 at(x + 0.01f * random(0), kCourse * (float(row) + 0.5f),
                               kWallZ + 0.045f * (random(1) - 0.5f));
            // Every other brick is rotated by half a turn, so that neighbours look different.
            const float yaw = (random(2) < 0.5f ? 0 : 3.1415927f) + 0.06f * (random(3) - 0.5f);
            place("brick", bricks[random(4) < 0.45f], at, yaw, {1, 0.98f + 0.03f * random(5), 1});
        }
    for (std::uint32_t i = 0; i < 19; ++i) {
        const float yaw = (i % 2 ? 3.1415927f : 0) + 0.03f * (hash_unit(i, 0, 610) - 0.5f);
        place("cap stone", cap,
              {-kHalfLength + 0.74f * float(i), 3 * kCourse + 0.042f,
               kWallZ + 0.02f * hash_unit(i, 1, 610)},
              yaw);
    }
}

void HeroBuilder::add_pebbles() {
    const int pebbles[2] = {single_mesh("pebble", make_pebble(620), materials_.stone),
                            single_mesh("warm pebble", make_pebble(640), materials_.warm_stone)};
    for (std::uint32_t i = 0; i < 70; ++i) {
        const float size = 0.018f + 0.05f * std::pow(hash_unit(i, 0, 650), 3.0f);
        const float x = 5.5f * (2 * hash_unit(i, 1, 650) - 1);
        const float z = kWallZ + 0.22f + 0.5f * std::pow(hash_unit(i, 2, 650), 2.0f);
        place("pebble", pebbles[i % 2], {x, 0.5f * size, z}, 6.28f * hash_unit(i, 3, 650),
              glm::vec3(size));
    }
    // A cairn on the parapet.
    float y = 0.592f;
    const std::array sizes = {0.17f, 0.135f, 0.11f, 0.08f, 0.055f, 0.035f};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const float rise = 0.55f * sizes[i];
        place("cairn", pebbles[i % 2], {-0.55f + 0.012f * std::sin(3 * float(i)), y + rise, kWallZ},
              1.9f * float(i), glm::vec3(sizes[i]));
        y += 1.93f * rise;
    }
}

void HeroBuilder::add_grass() {
    const int tufts[2] = {single_mesh("tuft", make_tuft(660), materials_.grass),
                          single_mesh("tuft", make_tuft(670), materials_.grass)};
    for (std::uint32_t i = 0; i < 110; ++i) {
        const float x = 6 * (2 * hash_unit(i, 0, 680) - 1);
        const float z = kWallZ + 0.19f + 0.12f * hash_unit(i, 1, 680);
        if (fbm({1.3f * x, 0}, 3, 0, 681) < -0.05f) continue;
        place("tuft", tufts[i % 2], {x, -0.005f, z}, 6.28f * hash_unit(i, 2, 680),
              glm::vec3(0.6f + 0.9f * hash_unit(i, 3, 680)));
    }
}

void HeroBuilder::add_landscape() {
    writer_.add_object("terrain", make_terrain(), materials_.terrain);
    writer_.add_object("near mist", make_mist(360, -190, -32), materials_.mist);
    writer_.add_object("valley mist", make_mist(620, -190, -12), materials_.mist);
    writer_.add_object("far mist", make_mist(1080, -170, 75), materials_.mist);
    const int tree = single_mesh("conifer", make_conifer(), materials_.conifer);
    std::uint32_t i = 0;
    for (const glm::vec4& at : place_trees(900))
        place("conifer", tree, glm::vec3(at), 6.28f * hash_unit(i++, 0, 690),
              glm::vec3(at.w, at.w * 1.15f, at.w));
}

}  // namespace hm
