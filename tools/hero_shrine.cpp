// The hero scene's chorten, its prayer flags, and lanterns.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "hero_objects.h"
#include "noise.h"

namespace hm {
namespace {

constexpr glm::vec3 kShrineAt(2.25f, 0, -0.75f);
constexpr float kShrineYaw = 0.50f;
constexpr float kShrineScale = 0.93f;
constexpr float kSpireTop = 2.98f;  // above the shrine's foot, before scaling

glm::mat4 lifted(float y) {
    return glm::translate(glm::mat4(1), glm::vec3(0, y, 0));
}

// Square steps from the floor upwards: half width and height of each.
TriangleMesh make_steps(std::span<const glm::vec2> steps, float from, float radius) {
    TriangleMesh mesh;
    float y = from;
    for (const glm::vec2& step : steps) {
        const glm::vec3 half(step.x, step.y / 2, step.x);
        append(mesh, make_rounded_box(half, radius, 0.9f), lifted(y + step.y / 2));
        y += step.y;
    }
    return mesh;
}

TriangleMesh make_dome() {
    const std::array<glm::vec2, 10> knots = {{{0.38f, 0},
                                              {0.40f, 0.05f},
                                              {0.40f, 0.05f},
                                              {0.415f, 0.10f},
                                              {0.475f, 0.34f},
                                              {0.49f, 0.47f},
                                              {0.43f, 0.60f},
                                              {0.28f, 0.69f},
                                              {0.14f, 0.72f},
                                              {0, 0.725f}}};
    return make_revolved(smooth_profile(knots, 6), 72, 3, 0.9f);
}

// Thirteen tapering rings, topped by a parasol, a vase and a flame.
TriangleMesh make_spire() {
    std::vector<glm::vec2> profile = {{0.19f, 0}};
    for (int ring = 0; ring < 13; ++ring) {
        const float y = 0.02f + 0.046f * float(ring), r = 0.165f - 0.0098f * float(ring);
        for (const glm::vec2& p :
             {glm::vec2(r - 0.022f, y), glm::vec2(r - 0.004f, y + 0.006f), glm::vec2(r, y + 0.018f),
              glm::vec2(r - 0.004f, y + 0.030f), glm::vec2(r - 0.022f, y + 0.036f)})
            profile.push_back(p);
    }
    const std::array<glm::vec2, 14> top = {{{0.03f, 0.63f},
                                            {0.03f, 0.66f},
                                            {0.03f, 0.66f},
                                            {0.17f, 0.665f},
                                            {0.17f, 0.665f},
                                            {0.165f, 0.69f},
                                            {0.10f, 0.73f},
                                            {0.03f, 0.75f},
                                            {0.022f, 0.78f},
                                            {0.05f, 0.82f},
                                            {0.055f, 0.85f},
                                            {0.022f, 0.89f},
                                            {0.012f, 0.93f},
                                            {0, 1.0f}}};
    const std::vector<glm::vec2> smooth = smooth_profile(top, 5);
    profile.insert(profile.end(), smooth.begin(), smooth.end());
    return make_revolved(profile, 48, 1, 1);
}

// A flag of 0.30 x 0.27 m, hanging from the origin along x; `phase` of the wind selects a variant.
TriangleMesh make_flag(float phase) {
    return make_surface(14, 12, [phase](float s, float t) {
        const float down = 1 - t;
        const float wave = 0.030f * std::sin(7 * s + 5 * down + phase) +
                           0.022f * std::sin(13 * s - 4 * down + 2.3f * phase);
        const float lift = 0.10f * down * down * (0.6f + 0.5f * std::sin(phase));
        return SurfacePoint{{0.30f * (s - 0.5f) + 0.012f * down * std::sin(phase + 4 * s),
                             -0.27f * down * (1 - 0.12f * down) + 0.01f * wave,
                             wave * std::sqrt(down + 0.02f) * 1.4f + lift},
                            {s, down}};
    });
}

glm::vec3 on_rope(glm::vec3 from, glm::vec3 to, float sag, float t) {
    return glm::mix(from, to, t) - glm::vec3(0, 4 * sag * t * (1 - t), 0);
}

}  // namespace

void HeroBuilder::add_shrine() {
    const std::array<glm::vec2, 3> base = {{{0.98f, 0.20f}, {0.84f, 0.20f}, {0.70f, 0.20f}}};
    const std::array<glm::vec2, 1> throne = {{{0.54f, 0.40f}}}, cornice = {{{0.62f, 0.075f}}},
                                   frieze = {{{0.585f, 0.05f}}};
    const std::array<glm::vec2, 3> upper = {{{0.53f, 0.085f}, {0.47f, 0.085f}, {0.41f, 0.085f}}};
    TriangleMesh plaster = make_steps(throne, 0.60f, 0.02f);
    append(plaster, make_steps(upper, 1.125f, 0.015f), glm::mat4(1));
    append(plaster, make_dome(), lifted(1.38f));
    TriangleMesh ochre = make_steps(cornice, 1.05f, 0.018f);
    const std::array<glm::vec2, 1> harmika = {{{0.17f, 0.15f}}}, band = {{{0.20f, 0.035f}}};
    append(ochre, make_steps(harmika, 2.08f, 0.012f), glm::mat4(1));
    TriangleMesh gold = make_steps(frieze, 1.00f, 0.012f);
    append(gold, make_steps(band, 2.215f, 0.008f), glm::mat4(1));
    const std::array<glm::vec2, 9> girdle = {{{0.40f, 0},
                                              {0.425f, 0.005f},
                                              {0.435f, 0.02f},
                                              {0.43f, 0.035f},
                                              {0.41f, 0.045f},
                                              {0.40f, 0.05f},
                                              {0.39f, 0.05f},
                                              {0.38f, 0.03f},
                                              {0.38f, 0.01f}}};
    append(gold, make_revolved(girdle, 72, 1, 1), lifted(1.395f));
    append(gold, make_spire(), lifted(2.24f));

    const std::array<GltfPrimitive, 4> parts = {
        {writer_.add_primitive(make_steps(base, 0, 0.03f), materials_.stone),
         writer_.add_primitive(plaster, materials_.plaster),
         writer_.add_primitive(ochre, materials_.ochre),
         writer_.add_primitive(gold, materials_.gold)}};
    place("chorten", writer_.add_mesh("chorten", parts), kShrineAt, kShrineYaw,
          glm::vec3(kShrineScale));
}

void HeroBuilder::add_flags() {
    const glm::vec3 top = kShrineAt + glm::vec3(0, kShrineScale * kSpireTop, 0);
    add_flag_line(top, {-6.2f, 3.75f, -2.9f}, 0.75f, 25);
    add_flag_line(top, {5.2f, 2.5f, 2.1f}, 0.35f, 10);
}

void HeroBuilder::add_flag_line(glm::vec3 from, glm::vec3 to, float sag, int count) {
    std::vector<glm::vec3> rope;
    for (int i = 0; i <= 48; ++i)
        rope.push_back(on_rope(from, to, sag, float(i) / 48));
    TriangleMesh tube = make_tube(rope, 0.006f, 6);
    writer_.add_object("rope", tube, materials_.rope);

    GltfPrimitive shapes[3];
    int meshes[3][5];  // created on first use
    for (int shape = 0; shape < 3; ++shape) {
        const float phase = 2.1f * float(shape) + float(count);
        shapes[shape] = writer_.add_primitive(make_flag(phase), materials_.flags[0]);
        std::fill_n(meshes[shape], 5, -1);
    }
    const float step = 0.93f / float(count);
    for (int i = 0; i < count; ++i) {
        const float t = 0.05f + step * float(i);
        // The x axis follows the rope from left to right, so that the print is not mirrored.
        glm::vec3 along = on_rope(from, to, sag, t + step) - on_rope(from, to, sag, t);
        if (along.x < 0) along = -along;
        const float swing = 0.25f * (hash_unit(std::uint32_t(i), std::uint32_t(count), 700) - 0.3f);
        const glm::quat yaw = glm::angleAxis(std::atan2(-along.z, along.x), glm::vec3(0, 1, 0));
        const glm::quat pitch = glm::angleAxis(
            std::atan2(along.y, glm::length(glm::vec2(along.x, along.z))), glm::vec3(0, 0, 1));
        const glm::quat sway = glm::angleAxis(-swing, glm::vec3(1, 0, 0));
        const std::uint32_t shape = hash(std::uint32_t(i), 1, 701) % 3;
        int& mesh = meshes[shape][i % 5];
        if (mesh < 0) {
            const GltfPrimitive primitive{shapes[shape].geometry, materials_.flags[i % 5]};
            mesh = writer_.add_mesh("flag", {&primitive, 1});
        }
        writer_.add_node({.name = "flag",
                          .translation = on_rope(from, to, sag, t + step / 2),
                          .rotation = yaw * pitch * sway,
                          .mesh = mesh});
    }
}

void HeroBuilder::add_lanterns() {
    const int lantern = make_lantern_mesh();
    place("lantern", lantern, {0.98f, 0, 0.15f}, 0.3f, glm::vec3(1.15f));
    place("lantern", lantern, {-2.5f, 0.592f, -2.44f}, 1.2f);
}

int HeroBuilder::make_lantern_mesh() {
    const std::array<glm::vec2, 9> foot = {{{0, 0},
                                            {0.11f, 0},
                                            {0.11f, 0},
                                            {0.115f, 0.012f},
                                            {0.105f, 0.03f},
                                            {0.09f, 0.036f},
                                            {0.09f, 0.036f},
                                            {0.05f, 0.036f},
                                            {0, 0.036f}}};
    const std::array<glm::vec2, 12> roof = {{{0.0f, 0.262f},
                                             {0.10f, 0.26f},
                                             {0.125f, 0.255f},
                                             {0.125f, 0.255f},
                                             {0.13f, 0.262f},
                                             {0.10f, 0.30f},
                                             {0.05f, 0.33f},
                                             {0.035f, 0.345f},
                                             {0.04f, 0.37f},
                                             {0.03f, 0.385f},
                                             {0.012f, 0.39f},
                                             {0, 0.39f}}};
    TriangleMesh metal = make_revolved(smooth_profile(foot, 4), 48, 1, 1);
    append(metal, make_revolved(smooth_profile(roof, 4), 48, 1, 1), glm::mat4(1));
    for (int i = 0; i < 6; ++i) {
        const float angle = 1.0471976f * float(i);
        const glm::vec3 at(0.094f * std::cos(angle), 0, 0.094f * std::sin(angle));
        const std::array<glm::vec3, 2> post = {at + glm::vec3(0, 0.03f, 0),
                                               at + glm::vec3(0, 0.262f, 0)};
        append(metal, make_tube(post, 0.0045f, 8), glm::mat4(1));
    }
    std::vector<glm::vec3> ring;
    for (int i = 0; i <= 24; ++i) {
        const float angle = 6.2831853f * float(i) / 24;
        ring.push_back({0.04f * std::sin(angle), 0.425f - 0.04f * std::cos(angle), 0});
    }
    append(metal, make_tube(ring, 0.004f, 8), glm::mat4(1));
    const std::array<glm::vec2, 2> pane = {{{0.086f, 0.036f}, {0.086f, 0.26f}}};
    const std::array<glm::vec2, 6> candle = {{{0.028f, 0.03f},
                                              {0.028f, 0.10f},
                                              {0.028f, 0.10f},
                                              {0.022f, 0.103f},
                                              {0.01f, 0.099f},
                                              {0, 0.098f}}};
    const std::array<glm::vec2, 6> flame = {{{0, 0.112f},
                                             {0.009f, 0.120f},
                                             {0.012f, 0.135f},
                                             {0.007f, 0.160f},
                                             {0.002f, 0.182f},
                                             {0, 0.19f}}};
    const std::array<GltfPrimitive, 4> parts = {
        {writer_.add_primitive(metal, materials_.brass),
         writer_.add_primitive(make_revolved(pane, 48, 1, 1), materials_.glass),
         writer_.add_primitive(make_revolved(candle, 24, 1, 1), materials_.wax),
         writer_.add_primitive(make_revolved(smooth_profile(flame, 3), 12, 1, 1),
                               materials_.flame)}};
    return writer_.add_mesh("lantern", parts);
}

}  // namespace hm
