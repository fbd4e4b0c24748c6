// The hero scene's table: singing bowl, copper ewer, vase with a flowering branch, butter lamps,
// prayer beads and a silk scarf. Positions on the table are in the table's frame, metres.
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "hero_objects.h"
#include "noise.h"

namespace hm {
namespace {

constexpr glm::vec3 kTableAt(-1.12f, 0, 1.75f);
constexpr float kTableYaw = 0.20f;
constexpr float kTableTop = 0.62f;
constexpr glm::vec2 kTableHalf(0.56f, 0.29f);

glm::vec3 on_table(float x, float z, float y = 0) {
    const glm::quat turn = glm::angleAxis(kTableYaw, glm::vec3(0, 1, 0));
    return kTableAt + turn * glm::vec3(x, kTableTop + y, z);
}

template <std::size_t N>
TriangleMesh turned(const std::array<glm::vec2, N>& knots, float u_repeats = 1,
                    float v_length = 1) {
    return make_revolved(smooth_profile(knots, 6), 72, u_repeats, v_length);
}

TriangleMesh make_bowl() {
    return turned<12>({{{0, 0},
                        {0.055f, 0},
                        {0.085f, 0.010f},
                        {0.122f, 0.040f},
                        {0.136f, 0.075f},
                        {0.138f, 0.098f},
                        {0.134f, 0.103f},
                        {0.129f, 0.098f},
                        {0.127f, 0.075f},
                        {0.112f, 0.042f},
                        {0.07f, 0.014f},
                        {0, 0.010f}}});
}

TriangleMesh make_ewer() {
    TriangleMesh mesh = turned<18>({{{0, 0},
                                     {0.072f, 0},
                                     {0.072f, 0},
                                     {0.078f, 0.010f},
                                     {0.062f, 0.030f},
                                     {0.105f, 0.075f},
                                     {0.132f, 0.130f},
                                     {0.128f, 0.185f},
                                     {0.085f, 0.235f},
                                     {0.050f, 0.270f},
                                     {0.043f, 0.315f},
                                     {0.058f, 0.355f},
                                     {0.066f, 0.362f},
                                     {0.066f, 0.362f},
                                     {0.058f, 0.366f},
                                     {0.040f, 0.345f},
                                     {0.034f, 0.31f},
                                     {0, 0.30f}}},
                                   3, 0.3f);
    const auto curve = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, float radius) {
        std::vector<glm::vec3> path;
        for (int i = 0; i <= 14; ++i) {
            const float t = float(i) / 14, s = 1 - t;
            path.push_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
        }
        append(mesh, make_tube(path, radius, 14), glm::mat4(1));
    };
    curve({0.052f, 0.335f, 0}, {0.17f, 0.40f, 0}, {0.20f, 0.22f, 0}, {0.122f, 0.12f, 0}, 0.010f);
    curve({-0.10f, 0.11f, 0}, {-0.20f, 0.12f, 0}, {-0.15f, 0.29f, 0}, {-0.225f, 0.345f, 0}, 0.015f);
    return mesh;
}

TriangleMesh make_vase() {
    return turned<15>({{{0, 0},
                        {0.050f, 0},
                        {0.050f, 0},
                        {0.053f, 0.012f},
                        {0.072f, 0.07f},
                        {0.098f, 0.15f},
                        {0.100f, 0.205f},
                        {0.072f, 0.265f},
                        {0.036f, 0.305f},
                        {0.030f, 0.345f},
                        {0.046f, 0.385f},
                        {0.043f, 0.390f},
                        {0.024f, 0.35f},
                        {0.022f, 0.31f},
                        {0, 0.30f}}});
}

TriangleMesh make_cushion() {
    return turned<8>({{{0, 0},
                       {0.12f, 0.0f},
                       {0.155f, 0.012f},
                       {0.165f, 0.026f},
                       {0.152f, 0.042f},
                       {0.11f, 0.046f},
                       {0.05f, 0.043f},
                       {0, 0.042f}}});
}

TriangleMesh make_leaf() {
    return make_surface(4, 6, [](float s, float t) {
        const float fold = std::abs(s - 0.5f);
        return SurfacePoint{
            {0.045f * (s - 0.5f), 0.11f * t - 0.03f * t * t, 0.012f * fold - 0.035f * t * t},
            {s, 1 - t}};
    });
}

// A trumpet of petals.
TriangleMesh make_blossom() {
    TriangleMesh mesh = make_surface(30, 5, [](float s, float t) {
        const float angle = 6.2831853f * s,
                    petals = 1 + 0.24f * t * std::abs(std::cos(2.5f * angle));
        const float r = (0.003f + 0.022f * t * t + 0.004f * t) * petals;
        return SurfacePoint{
            {r * std::sin(angle), 0.026f * t - 0.007f * t * t * t, r * std::cos(angle)}, {s, t}};
    });
    return mesh;
}

// A silk scarf over the table's front edge: flat for `kFlat`, then hanging.
TriangleMesh make_scarf() {
    constexpr float kFlat = 0.34f, kHang = 0.50f, kBend = 0.012f, kWidth = 0.21f;
    return make_surface(28, 80, [=](float s, float t) {
        const float along = (1 - t) * (kFlat + kHang);  // from the back, over the edge, down
        const float ripple =
            0.010f * std::sin(19 * s + 3 * along) + 0.006f * std::sin(33 * s - 5 * along + 1);
        const float hanging = std::max(0.0f, along - kFlat);
        const float gather = 1 - 0.25f * hanging / kHang;
        const float x = kWidth * (s - 0.5f) * gather + 0.02f * std::sin(6 * along);
        const float bend = std::min(hanging / kBend, 1.5707963f);
        const float z = std::min(along, kFlat) - kFlat + kBend * std::sin(bend);
        const float drop =
            kBend * (1 - std::cos(bend)) + std::max(0.0f, hanging - 1.5707963f * kBend);
        const float loose = std::min(1.0f, hanging / 0.12f);
        return SurfacePoint{{x, 0.0045f - drop + 0.12f * ripple * (1 - loose),
                             z + 1.4f * ripple * loose + 0.008f * loose},
                            {s, 1 - t}};
    });
}

}  // namespace

void HeroBuilder::add_still_life() {
    add_table();
    place("cushion", single_mesh("cushion", make_cushion(), materials_.cushion),
          on_table(0.02f, 0.02f));
    place("bowl", single_mesh("bowl", make_bowl(), materials_.brass),
          on_table(0.02f, 0.02f, 0.040f));
    place("ewer", single_mesh("ewer", make_ewer(), materials_.copper), on_table(0.33f, -0.08f),
          0.45f);
    place("vase", single_mesh("vase", make_vase(), materials_.celadon), on_table(-0.33f, -0.10f), 0,
          glm::vec3(1.05f));
    add_branch();
    // The mallet leans in the bowl.
    const std::array<glm::vec3, 2> mallet = {on_table(-0.02f, 0.02f, 0.066f),
                                             on_table(0.21f, 0.10f, 0.185f)};
    writer_.add_object("mallet", make_tube(mallet, 0.011f, 20), materials_.bead);
    const int butter_lamp = make_butter_lamp_mesh();
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 at = on_table(0.17f + 0.115f * float(i), 0.19f - 0.02f * float(i));
        place("butter lamp", butter_lamp, at, float(i));
    }
    place("scarf", single_mesh("scarf", make_scarf(), materials_.scarf),
          on_table(-0.17f, kTableHalf.y), kTableYaw);

    TriangleMesh bead = make_sphere(20, 10);
    const int bead_mesh = single_mesh("bead", bead, materials_.bead);
    constexpr int kBeads = 36;
    for (int i = 0; i < kBeads; ++i) {
        const float angle = 6.2831853f * float(i) / kBeads;
        const float r = 0.075f + 0.012f * std::sin(3 * angle + 1);
        const glm::vec3 at =
            on_table(-0.38f + r * std::cos(angle), 0.14f + 0.75f * r * std::sin(angle), 0.007f);
        place("bead", bead_mesh, at, 0, glm::vec3(0.007f));
    }
}

void HeroBuilder::add_table() {
    TriangleMesh wood, trim;
    const auto box = [](TriangleMesh& mesh, glm::vec3 half, glm::vec3 at, float radius) {
        append(mesh, make_rounded_box(half, radius, 1), glm::translate(glm::mat4(1), at));
    };
    box(wood, {kTableHalf.x, 0.02f, kTableHalf.y}, {0, kTableTop - 0.02f, 0}, 0.007f);
    box(trim, {kTableHalf.x - 0.012f, 0.006f, kTableHalf.y - 0.012f}, {0, kTableTop - 0.046f, 0},
        0.003f);
    box(wood, {kTableHalf.x - 0.04f, 0.045f, kTableHalf.y - 0.04f}, {0, kTableTop - 0.096f, 0},
        0.005f);
    for (const float x : {-1.0f, 1.0f})
        for (const float z : {-1.0f, 1.0f}) {
            const glm::vec3 corner(x * (kTableHalf.x - 0.065f), 0, z * (kTableHalf.y - 0.065f));
            box(wood, {0.032f, kTableTop / 2 - 0.02f, 0.032f},
                corner + glm::vec3(0, kTableTop / 2 - 0.02f, 0), 0.006f);
            box(trim, {0.037f, 0.018f, 0.037f}, corner + glm::vec3(0, 0.018f, 0), 0.004f);
        }
    const std::array<GltfPrimitive, 2> parts = {{writer_.add_primitive(wood, materials_.lacquer),
                                                 writer_.add_primitive(trim, materials_.gold)}};
    place("table", writer_.add_mesh("table", parts), kTableAt, kTableYaw);
}

void HeroBuilder::add_branch() {
    const int leaf = single_mesh("leaf", make_leaf(), materials_.leaf);
    const int blossom = single_mesh("blossom", make_blossom(), materials_.blossom);
    const glm::vec3 root = on_table(-0.33f, -0.10f, 0.36f);
    constexpr glm::vec3 kTwigs[4] = {{-0.20f, 0.34f, 0.05f},
                                     {0.07f, 0.44f, -0.03f},
                                     {0.20f, 0.26f, 0.06f},
                                     {-0.05f, 0.27f, 0.12f}};
    for (std::uint32_t twig = 0; twig < 4; ++twig) {
        std::vector<glm::vec3> path;
        for (int i = 0; i <= 12; ++i) {
            const float t = float(i) / 12;
            const glm::vec3 bend(0.02f * std::sin(7 * t + float(twig)), 0,
                                 0.015f * std::sin(9 * t));
            path.push_back(root + kTwigs[twig] * t + glm::vec3(0, -0.05f * t * t, 0) + bend * t);
        }
        writer_.add_object("twig", make_tube(path, 0.0035f, 8), materials_.bark);
        for (std::uint32_t i = 3; i <= 12; ++i) {
            const auto random = [&](std::uint32_t what) {
                return hash_unit(i, twig * 16 + what, 710);
            };
            const glm::quat out =
                glm::angleAxis(6.28f * (0.38f * float(i) + random(0) * 0.2f), glm::vec3(0, 1, 0)) *
                glm::angleAxis(0.6f + 0.7f * random(1), glm::vec3(1, 0, 0));
            const bool at_tip = i > 10;
            writer_.add_node({.name = "leaf",
                              .translation = path[i],
                              .rotation = out,
                              .scale = glm::vec3(0.7f + 0.5f * random(2)),
                              .mesh = leaf});
            for (std::uint32_t k = 0; at_tip && k < 4; ++k) {
                const glm::quat turn =
                    glm::angleAxis(1.57f * float(k) + random(3), glm::vec3(0, 1, 0)) *
                    glm::angleAxis(0.35f + 0.6f * hash_unit(i, k, 711), glm::vec3(1, 0, 0));
                writer_.add_node({.name = "blossom",
                                  .translation = path[i],
                                  .rotation = turn,
                                  .scale = glm::vec3(0.9f + 0.4f * random(4)),
                                  .mesh = blossom});
            }
        }
    }
}

int HeroBuilder::make_butter_lamp_mesh() {
    const TriangleMesh goblet = turned<15>({{{0, 0},
                                             {0.034f, 0},
                                             {0.034f, 0},
                                             {0.036f, 0.006f},
                                             {0.014f, 0.018f},
                                             {0.010f, 0.040f},
                                             {0.016f, 0.052f},
                                             {0.034f, 0.066f},
                                             {0.043f, 0.092f},
                                             {0.046f, 0.104f},
                                             {0.046f, 0.104f},
                                             {0.043f, 0.105f},
                                             {0.040f, 0.097f},
                                             {0.040f, 0.097f},
                                             {0.039f, 0.094f}}});
    const TriangleMesh butter = turned<3>({{{0.0395f, 0.094f}, {0.015f, 0.095f}, {0, 0.096f}}});
    const TriangleMesh flame =
        make_revolved(smooth_profile(std::array<glm::vec2, 6>{{{0, 0.100f},
                                                               {0.006f, 0.106f},
                                                               {0.008f, 0.116f},
                                                               {0.005f, 0.134f},
                                                               {0.0015f, 0.150f},
                                                               {0, 0.156f}}},
                                     3),
                      12, 1, 1);
    const std::array<GltfPrimitive, 3> parts = {{writer_.add_primitive(goblet, materials_.brass),
                                                 writer_.add_primitive(butter, materials_.wax),
                                                 writer_.add_primitive(flame, materials_.flame)}};
    return writer_.add_mesh("butter lamp", parts);
}

}  // namespace hm
